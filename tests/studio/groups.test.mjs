// Organisms in groups: made, selected, hidden, folded, moved in the list and over the ground, by mouse and keyboard.
import assert from 'node:assert/strict';
import {before, beforeEach, test} from 'node:test';
import {browse, drag, pixelOf, preset, shown, start, visit} from './studio.mjs';

const rock = (name, x, more = '') => `{"kind": "rock", "name": "${name}", "size": 0.3, "depth": 3, "place": {"at": [[${x}, 0]]}${more}}`;
const TEXT = `{
  "film": {"frames": 25, "fps": 24, "size": [320, 240]},
  "scene": {"setting": "studio", "camera": {"location": [0, 2, 4], "look_at": [0, 0.2, 0]}},
  "organisms": [
    ${rock('first', -1)}, // on the left
    ${rock('a', -0.4, ', "group": "pair"')},
    ${rock('between', 0)},
    ${rock('b', 0.4, ', "group": "pair"')}, /* with a */
    ${rock('last', 1)}
  ]
}`;

let browser, page, studio;
before(async () => {
  browser = await browse();
  studio = await start(preset('groups.json', TEXT));
});
beforeEach(async () => {
  await page?.context().close();
  page = await visit(browser, studio.address, {viewport: {width: 1100, height: 760}});
  await shown(page);
  await page.getByTestId('tab:text').click();
});

const text = () => page.evaluate(() => document.querySelector('[data-testid=text]').value);
const json = async () => JSON.parse((await text()).replace(/\/\*.*?\*\/|\/\/.*$/gm, ''));
const organism = entry => page.getByTestId(`organism:${entry}`);
const lines = () => page.locator('[data-testid=organisms] .what').allTextContents();
const spots = async () => (await json()).organisms.map(o => o.place.at[0]);
const undo = () => page.getByTestId('undo').click();

test('a group is a heading, by which its organisms are selected, hidden, folded and removed', async () => {
  assert.deepEqual(await lines(), ['first', 'pair', 'a', 'b', 'between', 'last']);
  await page.getByTestId('group:pair').click();
  for (const [entry, is] of [[0, null], [1, 'true'], [2, null], [3, 'true']]) assert.equal(await organism(entry).getAttribute('aria-current'), is);
  await page.getByTestId('hide:group:pair').click();
  for (const [entry, is] of [[1, 'true'], [2, 'false'], [3, 'true']]) assert.equal(await page.getByTestId(`hide:${entry}`).getAttribute('aria-pressed'), is);
  await page.getByTestId('hide:group:pair').click();
  assert.equal(await page.getByTestId('hide:3').getAttribute('aria-pressed'), 'false');
  await page.getByTestId('fold:pair').click();
  assert.deepEqual(await lines(), ['first', 'pair', 'between', 'last']);
  await page.getByTestId('group:pair').press('ArrowRight');
  assert.equal((await lines()).length, 6);
  await page.keyboard.press('ArrowLeft');
  assert.equal((await lines()).length, 4);
  // Hidden, solo and folds are no part of the preset.
  assert.equal(await text(), TEXT);
  await page.keyboard.press('Delete');
  assert.deepEqual((await json()).organisms.map(o => o.name), ['first', 'between', 'last']);
  await undo();
  assert.equal(await text(), TEXT);
  assert.deepEqual(page.faults, []);
});

test('a group is made of what is selected, renamed as a property, and taken apart', async () => {
  await organism(0).click();
  await organism(2).click({modifiers: ['Control']});
  await organism(2).focus();
  await page.keyboard.press('Control+g');
  assert.deepEqual((await json()).organisms.map(o => o.group), ['group 1', 'pair', 'group 1', 'pair', undefined]);
  assert.ok((await text()).includes('// on the left') && (await text()).includes('/* with a */'));
  const before = await page.evaluate(() => window.frond.view.header.regrown);
  await page.getByTestId('group:group 1').click();
  const name = page.locator('[data-testid="row:organism/group"] input');
  await name.fill('mine');
  await name.press('Tab');
  assert.deepEqual((await json()).organisms.map(o => o.group), ['mine', 'pair', 'mine', 'pair', undefined]);
  await shown(page);
  assert.deepEqual(await page.evaluate(() => window.frond.view.header.regrown), [], `nothing grows for it, as before ${before}`);
  await page.getByTestId('group:mine').focus();
  await page.keyboard.press('Control+Shift+G');
  assert.deepEqual(await lines(), ['first', 'pair', 'a', 'b', 'between', 'last']);
  for (let i = 0; i < 3; ++i) await undo();
  assert.equal(await text(), TEXT, 'each was one step');
  assert.deepEqual(page.faults, []);
});

test('a group moves in the list as one', async () => {
  await page.getByTestId('group:pair').focus();
  await page.keyboard.press('Alt+ArrowDown');
  assert.deepEqual((await json()).organisms.map(o => o.name), ['first', 'between', 'a', 'b', 'last']);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), 'group:pair');
  await page.keyboard.press('Alt+ArrowUp');
  assert.deepEqual((await json()).organisms.map(o => o.name), ['first', 'a', 'b', 'between', 'last']);
  // Another passes it as a whole.
  await organism(0).focus();
  await page.keyboard.press('Alt+ArrowDown');
  assert.deepEqual((await json()).organisms.map(o => o.name), ['a', 'b', 'first', 'between', 'last']);
  assert.ok((await text()).includes('// on the left') && (await text()).includes('/* with a */'));
  for (let i = 0; i < 3; ++i) await undo();
  assert.equal(await text(), TEXT);
  assert.deepEqual(page.faults, []);
});

test('what is dragged takes the others of its group along', async () => {
  await page.getByTestId('group:pair').click();
  const foot = await page.evaluate(() => window.frond.view.header.specimens.find(s => s.entry === 1).foot);
  await drag(page, await pixelOf(page, foot), await pixelOf(page, [foot[0], foot[1], foot[2] + 0.5]));
  const moved = await spots();
  const by = [moved[1][0] + 0.4, moved[1][1]];
  assert.ok(Math.abs(by[1] - 0.5) < 0.1 && Math.abs(by[0]) < 0.1, JSON.stringify(moved));
  assert.ok(Math.abs(moved[3][0] - 0.4 - by[0]) < 2e-3 && Math.abs(moved[3][1] - by[1]) < 2e-3, 'b goes as far');
  assert.deepEqual([moved[0], moved[2], moved[4]], [[-1, 0], [0, 0], [1, 0]]);
  await undo();
  assert.equal(await text(), TEXT, 'a drag is one step');
  await page.getByTestId('view').locator('canvas').first().focus();
  await page.keyboard.press('Alt+ArrowRight');
  await page.keyboard.press('Alt+Shift+ArrowDown');
  assert.deepEqual(await spots(), [[-1, 0], [-0.3, 1], [0, 0], [0.5, 1], [1, 0]]);
  await undo();
  await undo();
  assert.equal(await text(), TEXT);
  assert.deepEqual(page.faults, []);
});
