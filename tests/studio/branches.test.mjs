// Branches by hand: picked, cut, bent and strengthened with a real mouse and by the keyboard.
import assert from 'node:assert/strict';
import {before, beforeEach, afterEach, test} from 'node:test';
import {browse, changed, parts, pixelOf, preset, shown, start, visit} from './studio.mjs';

// A stem of 2 m with a bough to either side, and a tree that grows over years.
const TEXT = `// To be pruned.
{
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio", "camera": {"location": [0, 1, 6], "look_at": [0, 1, 0], "angle": 40}},
  "organisms": [
    {"kind": "plant", "name": "cross", "height": 0, "grammar": {"axiom": "FF[+(90)FFFF][-(90)FFFF]FF", "length": 0.3},
     "place": {"at": [[0, 0]], "size_variation": 0, "turn_variation": 0, "lean": 0}}, // its place
    {"kind": "tree", "name": "young", "years": 6, "place": {"at": [[-2, 0]], "size_variation": 0, "lean": 0}}
  ]
}
`;
let browser, page, studio;
before(async () => (browser = await browse()));
beforeEach(async () => {
  studio = await start(preset('branches.json', TEXT));
  page = await visit(browser, studio.address, {viewport: {width: 1280, height: 800}});
  await shown(page);
  await page.getByTestId('tool:branches').click();
});
afterEach(async () => {
  assert.deepEqual(page.faults, []);
  await page.context().close();
  await studio.stop();
});

const told = text => page.getByTestId('branch').getByText(text).waitFor();
async function now() {
  await page.getByTestId('tab:text').click();
  const text = await page.getByTestId('text').inputValue();
  await page.getByTestId('tab:text').click();
  return {text, edits: JSON.parse(text.replace(/\/\/.*$/gm, '')).organisms[0].edits};
}
/** The nodes that the first organism shows: the ends of its segments. */
const reach = () => page.evaluate(() => window.frond.view.header.entries[0].high);

test('edits that find no branch are said, kept apart, and taken out where that is wanted', async () => {
  await page.getByTestId('tab:text').click();
  const edits = '"edits": [{"at": "1", "cut": true}, {"at": "7:0.5", "cut": true}], "name": "cross"';
  await page.getByTestId('text').fill(TEXT.replace('"name": "cross"', edits));
  const lost = page.getByTestId('lost-edits');
  await lost.getByText('1 edit finds no branch').waitFor();
  await lost.locator('summary').click();
  await lost.getByText('cross: 7:0.5, cut.').waitFor();
  assert.match(await page.getByTestId('text').inputValue(), /7:0\.5/, 'it stays in the preset');
  await page.getByTestId('forget-lost').click();
  await lost.waitFor({state: 'hidden'});
  const left = await page.getByTestId('text').inputValue();
  assert.ok(left.includes('"at": "1"') && !left.includes('7:0.5'), left);
});

test('a bough is picked and cut by a click and a key, undone, and cut by its address', async () => {
  const was = await reach();
  await page.mouse.click(...(await pixelOf(page, [0.9, 0.6, 0])));
  await told(/cross, branch [12]:0\.7\d*: /);
  let before = await parts(page);
  await page.keyboard.press('Delete');
  await changed(page, before);
  await shown(page);
  let {edits, text} = await now();
  assert.equal(edits.length, 1);
  assert.equal(edits[0].cut, true);
  assert.ok(text.includes('// its place'));
  assert.ok((await reach())[0] < was[0] - 0.1, 'it is shorter');
  before = await parts(page);
  await page.getByTestId('undo').click();
  await changed(page, before);
  assert.equal((await now()).text, TEXT);

  await shown(page);
  await page.getByTestId('branch-address').fill('1:0.5');
  await page.getByTestId('branch-address').press('Enter');
  await told(/branch 1:0\.5/);
  await page.getByTestId('branch:upper').press('Enter');
  await told(/branch 2:0\.5/);
  await page.getByTestId('branch:cut').press('Enter');
  await shown(page);
  assert.deepEqual((await now()).edits, [{at: '2:0.5', cut: true}]);
});

test('the branch under the pointer is drawn over before it is clicked, and no more when the pointer leaves', async () => {
  await page.mouse.move(...(await pixelOf(page, [0.8, 0.6, 0])));
  await page.mouse.move(...(await pixelOf(page, [0.9, 0.6, 0])));
  await page.waitForFunction(() => document.querySelector('.trace polyline').getAttribute('points').split(' ').length > 1);
  await page.mouse.move(5, 5);
  await page.waitForFunction(() => !document.querySelector('.trace polyline').getAttribute('points'));
});

test('a bough is bent by dragging a point of it, which follows within 50 ms', async () => {
  await page.mouse.click(...(await pixelOf(page, [1.1, 0.6, 0])));
  await told(/cross, branch/);
  const from = await pixelOf(page, [1.1, 0.6, 0]), to = await pixelOf(page, [1.0, 1.1, 0]);
  const before = await parts(page);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0], from[1] - 8);
  const took = [];
  for (let i = 1; i <= 12; ++i) {
    const start = Date.now();
    await page.mouse.move(...from.map((x, k) => x + (i / 12) * (to[k] - x)));
    await page.evaluate(() => window.frond.view.tool.drawn.children.length);
    took.push(Date.now() - start);
  }
  await page.mouse.up();
  await changed(page, before);
  await shown(page);
  const [edit] = (await now()).edits;
  assert.ok(Math.abs(edit.bend[0] + 0.1) < 0.1 && Math.abs(edit.bend[1] - 0.5) < 0.1, JSON.stringify(edit));
  assert.ok((await reach())[1] > 1.0);
  took.sort((a, b) => a - b);
  console.log(`  a point follows within ${took[6]} ms, median`);
});

test('a branch of a tree is made stronger, and cut in a year of its life', async () => {
  await page.getByTestId('organism:1').click();
  await page.getByTestId('branch-address').fill(':0.3');
  await page.getByTestId('branch:find').click();
  await told(/young, branch :0\.3/);
  await page.getByTestId('branch:child').click();
  await told(/young, branch \d+:0\.[45]/);
  const before = await parts(page);
  await page.getByTestId('branch:stronger').click();
  await changed(page, before);
  await shown(page);
  await page.getByTestId('cut-year').fill('4');
  await page.getByTestId('branch:cut-year').click();
  await shown(page);
  await page.getByTestId('tab:text').click();
  const edits = JSON.parse((await page.getByTestId('text').inputValue()).replace(/\/\/.*$/gm, '')).organisms[1].edits;
  assert.equal(edits.length, 2);
  assert.equal(edits[0].strength, 1.25);
  assert.equal(edits[1].cut, 4);
});

test('a branch is stripped of its leaves by a button, which gives them back', async () => {
  await page.getByTestId('organism:1').click();
  await page.getByTestId('branch-address').fill(':0.3');
  await page.getByTestId('branch:find').click();
  await told(/young, branch :0\.3/);
  // By what is drawn: the header does not number again what the page has had before.
  const leaves = () => page.evaluate(() => window.frond.view.shown.filter(({part, thing}) => part.entry === 1 && part.kind === 'mesh' && thing.instanced).reduce((sum, {thing}) => sum + thing.count, 0));
  const was = await leaves();
  assert.ok(was > 0);
  const bare = page.getByTestId('branch:bare');
  const first = await parts(page);
  await bare.click();
  await changed(page, first);
  await shown(page);
  assert.ok((await leaves()) < was / 2, `${await leaves()} of ${was} leaves are left`);
  const edits = async () => {
    await page.getByTestId('tab:text').click();
    const text = await page.getByTestId('text').inputValue();
    await page.getByTestId('tab:text').click();
    return JSON.parse(text.replace(/\/\/.*$/gm, '')).organisms[1].edits;
  };
  const [edit, ...more] = await edits();
  assert.deepEqual([edit.bare, more], [true, []]);
  await page.waitForFunction(() => document.querySelector('[data-testid="branch:bare"]').getAttribute('aria-pressed') === 'true');
  const stripped = await parts(page);
  await bare.click();
  await changed(page, stripped);
  await shown(page);
  assert.equal(await parts(page), first, 'the picture is the former one');
  assert.equal(await edits(), undefined);
});

test('a branch wears another bark, in any colour, and the former one again', async () => {
  await page.getByTestId('organism:0').click();
  await page.getByTestId('branch-address').fill('1:0');
  await page.getByTestId('branch:find').click();
  await told(/cross, branch 1: /);
  const woods = () => page.evaluate(() => window.frond.view.header.parts.filter(part => part.entry === 0 && part.kind === 'tubes').length);
  assert.equal(await woods(), 1);
  const list = page.getByTestId('branch:bark');
  assert.equal(await list.inputValue(), 'own');
  let before = await parts(page);
  await list.selectOption('painted');
  await changed(page, before);
  await shown(page);
  assert.equal(await woods(), 2, 'the branch is drawn apart');
  let {edits} = await now();
  assert.deepEqual(edits, [{at: '1', bark: {kind: 'ink', color: '#b3362b'}}]);
  await page.waitForFunction(() => document.querySelector('[data-testid="branch:bark-color"]').value === '#b3362b');
  before = await parts(page);
  await page.getByTestId('branch:bark-color').fill('#2244cc');
  await changed(page, before);
  await shown(page);
  ({edits} = await now());
  assert.deepEqual(edits, [{at: '1', bark: {kind: 'ink', color: '#2244cc'}}]);
  assert.equal(await list.inputValue(), 'painted');
  before = await parts(page);
  await list.selectOption('own');
  await changed(page, before);
  await shown(page);
  assert.equal(await woods(), 1);
  ({edits} = await now());
  assert.equal(edits, undefined);
});
