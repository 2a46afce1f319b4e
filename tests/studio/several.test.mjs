// Several organisms at once, their order, keys on the timeline, and views beside and over the first.
import assert from 'node:assert/strict';
import {before, beforeEach, test} from 'node:test';
import {browse, choose, preset, shown, start, visit} from './studio.mjs';

const TEXT = `{
  "film": {"frames": 49, "fps": 24, "size": [320, 240]},
  "scene": {"setting": "studio", "camera": {"location": [0, 1.2, 3], "look_at": [0, 0.3, 0], "angle": [[0, 50], [1, 30]]}},
  "organisms": [
    {"kind": "rock", "name": "left", "size": 0.4, "depth": 3, "place": {"at": [[-0.6, 0]]}}, // the first
    {"kind": "rock", "name": "middle", "size": 0.4, "depth": 3, "place": {"at": [[0, 0]]}},
    {"kind": "column", "name": "right", "height": 0.6, "place": {"at": [[0.7, 0]]}}
  ]
}`;

let browser, page, studio;
before(async () => {
  browser = await browse();
  studio = await start(preset('several.json', TEXT));
});
beforeEach(async () => {
  await page?.context().close();
  page = await visit(browser, studio.address);
  await shown(page);
});

const text = () => page.evaluate(() => document.querySelector('[data-testid=text]').value);
const open = async name => (await page.getByTestId(`tab:${name}`).getAttribute('aria-selected')) === 'true' || page.getByTestId(`tab:${name}`).click();
const organism = entry => page.getByTestId(`organism:${entry}`);

test('several are selected, changed at once as one step, hidden and removed', async () => {
  await open('text');
  await organism(0).click();
  await organism(1).click({modifiers: ['Control']});
  assert.equal(await page.evaluate(() => window.frond.view.painter.marked.size > 1), true);
  const box = page.locator('[data-testid="row:organism/size"] input.number');
  await box.fill('0.5');
  await box.press('Enter');
  assert.equal(await text(), TEXT.replaceAll('"size": 0.4', '"size": 0.5'));
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT);
  // What only the stones have is not written into the column.
  await organism(2).click();
  await organism(0).click({modifiers: ['Shift']});
  await box.fill('0.6');
  await box.press('Enter');
  assert.equal(await text(), TEXT.replaceAll('"size": 0.4', '"size": 0.6'));
  await page.getByTestId('undo').click();
  await page.getByTestId('hide:1').click();
  for (const entry of [0, 1, 2]) assert.equal(await page.getByTestId(`hide:${entry}`).getAttribute('aria-pressed'), 'true');
  await page.getByTestId('hide:1').click();
  await organism(0).focus();
  await page.keyboard.press('Delete');
  assert.equal(await page.locator('[data-testid^="organism:"]').count(), 0);
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT);
  assert.deepEqual(page.faults, []);
});

test('by the keyboard the selection grows, and an organism changes its place in the list with its comment', async () => {
  await open('text');
  await organism(0).click();
  await page.keyboard.press('Shift+ArrowDown');
  for (const [entry, is] of [[0, 'true'], [1, 'true'], [2, null]]) assert.equal(await organism(entry).getAttribute('aria-current'), is);
  await organism(1).click();
  await page.keyboard.press('Alt+ArrowDown');
  const names = await page.locator('[data-testid^="organism:"] .what').allTextContents();
  assert.deepEqual(names, ['left', 'right', 'middle']);
  assert.equal(await organism(2).getAttribute('aria-current'), 'true');
  assert.ok((await text()).includes('// the first'));
  assert.deepEqual(page.faults, []);
});

test('a key on the timeline is dragged, moved by arrow keys, and removed', async () => {
  await open('text');
  await page.getByTestId('part:scene').click();
  const mark = page.getByTestId('time-key:1');
  const [box, track] = [await mark.boundingBox(), await page.locator('.marks').boundingBox()];
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(...middle);
  await page.mouse.down();
  for (const share of [0.1, 0.2, 0.25]) await page.mouse.move(middle[0] + share * track.width, middle[1]);
  await page.mouse.up();
  assert.equal(await text(), TEXT.replace('[1, 30]', '[1.5, 30]'));
  await page.getByTestId('time-key:1.5').press('ArrowLeft');
  assert.equal(await text(), TEXT.replace('[1, 30]', '[1.458, 30]'));
  await page.getByTestId('undo').click();
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT, 'a drag is one step');
  // It does not pass the key before it.
  await page.getByTestId('time-key:1').focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('Shift+ArrowLeft');
  assert.equal(await text(), TEXT.replace('[1, 30]', '[0.042, 30]'));
  await page.keyboard.press('Delete');
  assert.equal(await text(), TEXT.replace('[[0, 50], [1, 30]]', '[[0, 50]]'));
  assert.deepEqual(page.faults, []);
});

test('a second view shows the model from its own side, and follows what is changed', async () => {
  await choose(page, 'views', 'two-views');
  const canvas = page.locator('[data-testid=second-view] canvas');
  const seen = () => canvas.screenshot().then(png => png.toString('base64'));
  await choose(page, 'second-views', 'second:top');
  await page.waitForTimeout(500);
  const before = await seen();
  await organism(0).click();
  const slider = page.locator('[data-testid="row:organism/size"] input[type=range]');
  await slider.focus();
  for (let i = 0; i < 10; ++i) await page.keyboard.press('ArrowRight');
  for (let now = before; now === before; now = await seen()) await page.waitForTimeout(200);
  await choose(page, 'views', 'two-views');
  assert.equal(await canvas.count(), 0);
  assert.deepEqual(page.faults, []);
});

test('what was kept as A is seen beside what it became, from the same place, and comes back', async () => {
  await open('text');
  await choose(page, 'views', 'keep-a');
  await organism(1).click();
  const box = page.locator('[data-testid="row:organism/size"] input.number');
  await box.fill('0.9');
  await box.press('Enter');
  await shown(page);
  const kept = page.locator('.kept canvas');
  await kept.waitFor();
  const size = async one => one.evaluate(canvas => [canvas.width, canvas.height]);
  assert.deepEqual(await size(kept), await size(page.locator('[data-testid=view] > canvas').first()));
  await page.getByTestId('keep-wipe').focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.getByTestId('keep-wipe').inputValue(), '51');
  await page.getByTestId('back-to-a').click();
  assert.equal(await text(), TEXT);
  await page.getByTestId('undo').click();
  assert.ok((await text()).includes('0.9'));
  await choose(page, 'views', 'keep-a');
  assert.equal(await kept.count(), 0);
  assert.deepEqual(page.faults, []);
});
