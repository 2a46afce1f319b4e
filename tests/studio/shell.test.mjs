// What stands round the view: tools, views, help, what is selected first, and how it is on a phone and by keyboard.
import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {TEXT} from './plant.mjs';
import {browse, choose, preset, shown, start, visit} from './studio.mjs';

const POTTED = TEXT.replace('"organisms": [', '"organisms": [{"kind": "vase", "name": "pot", "height": 0.1, "place": {"at": [[1, 0]]}},');
let browser, studio, page;
before(async () => {
  browser = await browse();
  studio = await start(preset('potted.json', POTTED));
  page = await visit(browser, studio.address, {viewport: {width: 1024, height: 768}});
  await shown(page);
});

/** Where the corners of the film's frame are in the window, -1..1. */
const corners = () => page.evaluate(() => {
  const {eyes, camera} = window.frond.view;
  return [[-1, -1], [1, 1]].flatMap(([x, y]) => {
    const at = camera.position.clone().set(x, y, 0.5).unproject(eyes.filmCamera()).project(camera);
    return [at.x, at.y];
  });
});

test('the whole frame of the film is in the window at first, whatever its shape', async () => {
  for (const size of [{width: 1024, height: 768}, {width: 1280, height: 720}, {width: 700, height: 900}]) {
    await page.setViewportSize(size);
    await page.evaluate(() => window.frond.view.drawn());
    for (const at of await corners()) assert.ok(Math.abs(at) < 0.97, `${at} in ${size.width} x ${size.height}`);
  }
  await page.setViewportSize({width: 1024, height: 768});
});

test('the subject is selected at first, not the pot beside it', async () => {
  assert.equal(await page.getByTestId('organism:1').getAttribute('aria-current'), 'true');
});

test('what shapes a plant leads, and what only lists it comes last', async () => {
  const rows = await page.locator('.properties [data-testid*=":organism/"]').evaluateAll(list => list.map(one => one.dataset.testid));
  assert.equal(rows[0], 'row:organism/species');
  assert.equal(rows[1], 'row:organism/height');
  assert.ok(rows.indexOf('lead:organism/grammar/angle') < rows.indexOf('row:organism/by_steps'), rows.join());
  assert.deepEqual(rows.slice(-3).sort(), ['count', 'group', 'name'].map(name => `row:organism/${name}`), rows.join());
});

test('another bark is chosen by its picture, as one step', async () => {
  await page.getByTestId('swap-surface').click();
  await page.getByTestId('swaps').getByRole('button').first().click();
  await page.waitForFunction(() => document.querySelector('[data-testid=undo]').disabled === false);
  await page.getByTestId('undo').click();
  assert.equal(await page.getByTestId('undo').isDisabled(), true);
});

test('no button is cut off, with a second view beside', async () => {
  await choose(page, 'views', 'two-views');
  await page.locator('[data-testid=second-view] canvas').waitFor();
  const cut = await page.locator('.stage button:visible, .second-view button:visible').evaluateAll(list => list.filter(one => {
    const box = one.getBoundingClientRect(), around = one.closest('.stage, .second-view').getBoundingClientRect();
    return box.left < around.left || box.right > around.right || box.bottom > around.bottom || one.scrollWidth > one.clientWidth + 1;
  }).map(one => one.textContent));
  assert.deepEqual(cut, []);
  await choose(page, 'second-views', 'second:close');
});

test('a question mark lists the keys, and leads to the documentation', async () => {
  await page.evaluate(() => window.frond.view.focus());
  await page.keyboard.press('?');
  await page.getByTestId('keys').getByText('look through the camera').waitFor();
  const href = await page.getByTestId('doc:presets.md').evaluate(link => link.href);
  const read = await page.evaluate(href => fetch(href).then(answer => answer.text()), href);
  assert.match(read, /^# /);
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => document.activeElement.className.includes('view-canvas')), true);
});

test('the focus stays where one works when a card is opened and left', async () => {
  await page.getByTestId('to-gallery').click();
  const card = page.locator('[data-testid="own:potted.json"]');
  await card.focus();
  await page.keyboard.press('Enter');
  await shown(page);
  assert.equal(await page.evaluate(() => document.activeElement.className.includes('view-canvas')), true);
  assert.deepEqual(page.faults, []);
});

test('on a phone one sheet is open at a time, the bar takes one row and the view keeps its room', async () => {
  const phone = await visit(browser, studio.address, {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true});
  await shown(phone);
  const height = name => phone.locator(name).evaluate(one => one.getBoundingClientRect().height);
  assert.ok((await height('.top-bar')) < 60);
  assert.match(await phone.getByTestId('to-gallery').evaluate(one => one.getAttribute('aria-label')), /Frond/);
  await phone.getByTestId('tab:grammar').click();
  assert.ok((await height('[data-testid=view]')) > 250, 'with the grammar open');
  await phone.getByTestId('side').click();
  assert.equal(await phone.getByTestId('tab:grammar').getAttribute('aria-selected'), 'false');
  assert.ok((await height('[data-testid=view]')) > 200, 'with the properties open');
  await phone.getByTestId('tab:text').click();
  assert.equal(await phone.locator('aside.side').isVisible(), false);
  assert.deepEqual(await small(phone), []);
  assert.deepEqual(phone.faults, []);
  await phone.context().close();
});

/** Buttons that are too small for a finger; those in rows of properties may be lower. */
const small = page => page.locator('button:visible').evaluateAll(list => list.filter(one => {
  const {width, height} = one.getBoundingClientRect(), row = one.closest('.row');
  return height < (row ? 36 : 44) || width < (row ? 24 : 44);
}).map(one => one.outerHTML.slice(0, 90)));

/** What reaches beyond the window's sides. */
const cut = page => page.locator('button:visible, input:visible, select:visible').evaluateAll(list => list.filter(one => {
  const {left, right} = one.getBoundingClientRect();
  return left < -1 || right > innerWidth + 1;
}).map(one => one.outerHTML.slice(0, 90)));

test('on a phone nothing is too small for a finger or cut off, and a tall drawer leaves the view 40 % of the height', async () => {
  const phone = await visit(browser, studio.address, {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true});
  await shown(phone);
  const view = () => phone.getByTestId('view').evaluate(one => one.getBoundingClientRect().height / innerHeight);
  for (const tab of ['grammar', 'text', 'curves', 'library', 'film', 'renders']) {
    await phone.getByTestId(`tab:${tab}`).click();
    assert.deepEqual([await small(phone), await cut(phone)], [[], []], tab);
  }
  // As it was drawn on a large screen, by the keys, and where the phone is turned and turned back.
  await phone.getByTestId('tab:grammar').click();
  for (let i = 0; i < 30; ++i) await phone.locator('.edge').press('ArrowUp');
  assert.ok(await view() >= 0.4, `${await view()}`);
  await phone.setViewportSize({width: 390, height: 600});
  await phone.setViewportSize({width: 390, height: 844});
  assert.ok(await view() >= 0.4, `${await view()}`);
  for (const tool of ['place', 'branches', 'draw', 'paint', 'measure']) {
    await phone.getByTestId(`tool:${tool}`).click();
    assert.deepEqual([await small(phone), await cut(phone)], [[], []], tool);
  }
  await phone.getByTestId('side').click();
  assert.deepEqual([await small(phone), await cut(phone)], [[], []], 'properties');
  // What opened a menu has the focus again.
  await phone.getByTestId('more-acts').click();
  assert.deepEqual([await small(phone), await cut(phone)], [[], []], 'menu');
  await phone.keyboard.press('Escape');
  assert.equal(await phone.evaluate(() => document.activeElement.dataset.testid), 'more-acts');
  await phone.getByTestId('to-gallery').click();
  await phone.locator('[data-testid^="card:"]').first().waitFor();
  assert.deepEqual([await small(phone), await cut(phone)], [[], []], 'gallery');
  assert.deepEqual(phone.faults, []);
  await phone.context().close();
});

test('whatever has a sign alone is called by what it does', async () => {
  await page.getByTestId('to-gallery').waitFor();
  for (const tool of ['place', 'branches', 'draw', 'paint', 'measure', 'select']) {
    await page.getByTestId(`tool:${tool}`).click();
    const nameless = await page.locator('button:visible').evaluateAll(list => list.filter(one => !/\w/.test(one.getAttribute('aria-label') ?? one.textContent)).map(one => one.outerHTML.slice(0, 90)));
    assert.deepEqual(nameless, [], tool);
  }
});
