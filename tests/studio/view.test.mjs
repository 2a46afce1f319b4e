// How a person looks at what is there: turning, framing, marks, what is shown in a small window.
import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {browse, choose, pixelOf, preset, shown, start, visit} from './studio.mjs';

const TEXT = `{
  "film": {"frames": 1, "size": [320, 240]},
  "scene": {"setting": "studio", "camera": {"location": [0, 1.2, 3], "look_at": [0, 0.3, 0], "angle": 50}},
  "organisms": [
    {"kind": "rock", "name": "stone", "size": 0.6, "depth": 5, "place": {"at": [[0, 0]]}},
    {"kind": "coral", "name": "coral", "steps": 3, "height": 0.3, "place": {"at": [[1, 0]]}}
  ]
}`;

let browser, page, studio;
before(async () => {
  browser = await browse();
  studio = await start(preset('view.json', TEXT));
  page = await visit(browser, studio.address);
  await shown(page);
});

const eye = () => page.evaluate(() => window.frond.view.eye());
const text = () => page.getByTestId('text').inputValue();
const marked = () => page.evaluate(() => window.frond.view.painter.marked.size);

const pixel = at => pixelOf(page, at);

/** How much of the window's height and width an organism takes. */
const taken = entry =>
  page.evaluate(entry => {
    const {view} = window.frond, {low, high} = view.header.entries[entry];
    const at = [];
    for (let i = 0; i < 8; ++i) at.push(view.toPixel(view.filmEye.set(...[0, 1, 2].map(k => (i >> k & 1 ? high : low)[k]))));
    const span = (of, whole) => [Math.min(...at.map(of)) / whole, Math.max(...at.map(of)) / whole];
    return [span(p => p.x, view.canvas.clientWidth), span(p => p.y, view.canvas.clientHeight)];
  }, entry);

test('nothing is marked on opening, and a drag on any organism turns the view', async () => {
  await page.getByTestId('tab:text').click();
  assert.equal(await marked(), 0);
  const spot = await pixel([0, 0.25, 0]);
  await page.mouse.click(...spot);
  await page.waitForFunction(() => window.frond.view.painter.marked.size > 0);
  const was = await eye();
  await page.mouse.move(...spot);
  await page.mouse.down();
  await page.mouse.move(spot[0] + 80, spot[1] + 10, {steps: 4});
  await page.mouse.up();
  await page.waitForFunction(was => Math.hypot(...window.frond.view.eye().at.map((x, i) => x - was[i])) > 0.2, was.at);
  assert.equal(await text(), TEXT, 'nothing was moved');
});

test('what is marked keeps its colours', async () => {
  await page.evaluate(() => window.frond.view.pictured());
  const colors = () =>
    page.evaluate(async () => {
      const {view} = window.frond;
      await window.frond.settled();
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [view.canvas.width, view.canvas.height];
      const pen = copy.getContext('2d');
      pen.drawImage(view.canvas, 0, 0);
      const {x, y} = view.toPixel(view.filmEye.set(0, 0.25, 0));
      // The mean of some pixels, since the skin has a pattern and the view comes slowly to rest.
      const {data} = pen.getImageData(x * copy.width / view.canvas.clientWidth - 4, y * copy.height / view.canvas.clientHeight - 4, 9, 9);
      return [0, 1, 2].map(c => Math.round(data.filter((_, i) => i % 4 === c).reduce((sum, v) => sum + v, 0) / 81));
    });
  await page.evaluate(() => window.frond.view.select(0));
  const on = await colors();
  await page.evaluate(() => window.frond.view.select(null));
  const off = await colors();
  on.forEach((c, i) => assert.ok(Math.abs(c - off[i]) <= 8, `${on} and ${off}`));
});

test('what is selected is brought into the window, from all sides', async () => {
  await page.getByTestId('organism:1').click();
  for (const name of ['frame', 'front', 'side', 'top']) {
    await choose(page, 'views', `view:${name}`);
    await page.evaluate(() => window.frond.view.drawn());
    for (const [low, high] of await taken(1)) assert.ok(low > 0 && high < 1, `${name}: ${low} to ${high}`);
    assert.ok((await taken(1)).some(([low, high]) => high - low > 0.25), `${name}: it is too far away`);
  }
  await page.getByTestId('tab:problems').click();
  await page.locator('.view-canvas').focus();
  await page.keyboard.press('Home');
  await page.evaluate(() => window.frond.view.drawn());
  (await eye()).at.forEach((x, i) => assert.ok(Math.abs(x - [0, 1.2, 3][i]) < 1e-4));
  await page.keyboard.press('7');
  const {at, to} = await eye();
  assert.ok(at[1] - to[1] > 10 * Math.hypot(at[0] - to[0], at[2] - to[2]), 'from above');
});

test('what is added is all in the window', async () => {
  await page.getByTestId('add-organism').click();
  assert.notEqual(await page.evaluate(() => document.activeElement.type), 'file');
  await page.getByTestId('add:plant').click();
  await page.waitForFunction(() => window.frond.view.header.entries.length === 3);
  await shown(page);
  for (const [low, high] of await taken(2)) assert.ok(low > 0 && high < 1, `${low} to ${high}`);
});

test('in a small window the properties can be hidden, and the view is seen', async () => {
  const small = await visit(browser, studio.address, {viewport: {width: 390, height: 780}});
  await shown(small);
  const view = small.getByTestId('view'), side = small.locator('aside.side');
  assert.equal(await side.isVisible(), false);
  assert.ok((await view.boundingBox()).height > 300);
  await small.getByTestId('side').click();
  await side.waitFor();
  const [above, below] = [await view.boundingBox(), await side.boundingBox()];
  assert.ok(above.height > 150 && above.y + above.height <= below.y + 1, 'they stand one above the other');
  assert.ok((await small.getByTestId('render').boundingBox()).x + 20 < 390);
  await small.getByTestId('side').click();
  assert.equal(await side.isVisible(), false);
  assert.equal(await small.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(small.faults, []);
  await small.context().close();
});

test('what is shown is what the page has no complaint of', () => assert.deepEqual(page.faults, []));
