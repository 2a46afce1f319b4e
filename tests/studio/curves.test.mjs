// Keys on curves over the film's time, and the camera's way in the view with its handles; by mouse and keyboard.
import assert from 'node:assert/strict';
import {before, beforeEach, test} from 'node:test';
import {browse, drag, pixelOf, preset, shown, start, visit} from './studio.mjs';

const TEXT = `{
  "film": {"frames": 49, "fps": 24, "size": [320, 240]},
  "scene": {"setting": "studio", "camera": {
    "location": [[0, [-1, 0.6, 3]], [2, [1, 0.6, 3]]], // from left to right
    "look_at": [0, 0.3, 0],
    "angle": [[0, 50], /* wide */ [1, 30], [2, 40]]}},
  "organisms": [{"kind": "rock", "size": 0.4, "depth": 3, "place": {"at": [[0, 0]]}}]
}`;

let browser, page;
before(async () => (browser = await browse()));
async function open(text) {
  await page?.context().close();
  const studio = await start(preset('curves.json', text));
  page = await visit(browser, studio.address, {viewport: {width: 1200, height: 800}});
  await shown(page);
  await page.getByTestId('part:scene').click();
}
beforeEach(() => open(TEXT));

const text = () => page.evaluate(() => {
  dispatchEvent(new Event('pagehide'));
  return JSON.parse(sessionStorage.getItem('frond.draft')).text;
});
const json = async () => JSON.parse((await text()).replace(/\/\*.*?\*\/|\/\/.*$/gm, ''));
const angle = async () => (await json()).scene.camera.angle;
const location = async () => (await json()).scene.camera.location;
const undo = () => page.getByTestId('undo').click();
const middle = async one => {
  // What is drawn anew has no box for a moment.
  let box = null;
  while (!box) {
    await one.waitFor();
    box = await one.boundingBox();
  }
  return [box.x + box.width / 2, box.y + box.height / 2];
};
/** From in front of a place. */
const lookAt = ([x, y, z]) => page.evaluate(([x, y, z]) => {
  window.frond.view.goTo([x, y + 0.3, z + 5], [x, y, z]);
  return window.frond.view.drawn();
}, [x, y, z]);
const curve = async of => {
  await page.getByTestId('tab:curves').click();
  await page.getByTestId('curve-of').selectOption(of);
};

test('a key is dragged along in time and up in value, as one step', async () => {
  await curve('/scene/camera/angle');
  const key = page.getByTestId('curve-key:1:0');
  const [x, y] = await middle(key);
  await drag(page, [x, y], [x + 5, y - 10], [x + 60, y - 30]);
  const [, [time, value]] = await angle();
  assert.ok(time > 1.05 && time < 1.6, `${time}`);
  assert.ok(Math.abs(time * 24 - Math.round(time * 24)) < 0.02, 'on a frame');
  assert.ok(value > 32 && value < 50, `${value}`);
  // It is still below the pointer.
  const [now, high] = await middle(key);
  assert.ok(Math.abs(now - x - 60) < 12, `${now - x}`);
  assert.ok((await text()).includes('/* wide */') && high > 0);
  await undo();
  assert.equal(await text(), TEXT);
  assert.deepEqual(page.faults, []);
});

test('by the keyboard a key moves, goes, and says how it goes on', async () => {
  await curve('/scene/camera/angle');
  await page.getByTestId('curve-key:1:0').focus();
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Shift+ArrowUp');
  const [, [time, value]] = await angle();
  assert.equal(time, 0.958);
  assert.ok(value > 31 && value < 34, `${value}`);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), 'curve-key:1:0');
  const line = () => page.locator('.curves polyline').getAttribute('points');
  const before = await line();
  await page.getByTestId('curve-ease:in').press('Enter');
  assert.deepEqual((await angle())[1], [0.958, value, 'in']);
  assert.notEqual(await line(), before);
  await shown(page);
  assert.equal(await page.evaluate(() => window.frond.view.header !== null), true, 'the engine reads it');
  await page.getByTestId('curve-ease:smooth').press('Enter');
  assert.equal(await line(), before);
  await page.getByTestId('curve-key:2:0').focus();
  assert.equal(await page.getByTestId('curve-ease:in').isDisabled(), true, 'nothing comes after the last');
  await page.keyboard.press('Delete');
  assert.deepEqual((await angle()).map(([t]) => t), [0, 0.958]);
  assert.ok((await text()).includes('/* wide */'));
  for (let i = 0; i < 5; ++i) await undo();
  assert.equal(await text(), TEXT);
  // What the preset does not allow is not reached.
  await page.getByTestId('curve-key:0:0').focus();
  for (let i = 0; i < 40; ++i) await page.keyboard.press('Shift+ArrowDown');
  assert.equal((await angle())[0][1], 1);
  assert.deepEqual(page.faults, []);
});

test('a key is added where one clicks twice, and each number of a place has its curve', async () => {
  await curve('/scene/camera/location');
  assert.equal(await page.locator('.curves polyline').count(), 3);
  const [a, b] = [await middle(page.getByTestId('curve-key:0:2')), await middle(page.getByTestId('curve-key:1:2'))];
  await page.mouse.dblclick((a[0] + b[0]) / 2, a[1] - 20);
  assert.deepEqual((await location())[1], [1, [0, 0.6, 3]]);
  const [x, y] = await middle(page.getByTestId('curve-key:1:1'));
  await drag(page, [x, y], [x, y - 40]);
  const [, [, at]] = await location();
  assert.ok(at[0] === 0 && at[1] > 0.8 && at[2] === 3, `${at}`);
  assert.ok((await text()).includes('// from left to right'));
  await undo();
  await undo();
  assert.equal(await text(), TEXT);
  assert.deepEqual(page.faults, []);
});

test("the camera's way has points and handles that are dragged", async () => {
  await lookAt([0, 0.6, 3]);
  await page.getByTestId('tool:draw').click();
  await page.getByTestId('draw-what').selectOption('way');
  await drag(page, await pixelOf(page, [-1, 0.6, 3]), await pixelOf(page, [-1, 0.9, 3]));
  const [[, at]] = await location();
  assert.ok(Math.abs(at[1] - 0.9) < 0.05 && Math.abs(at[0] + 1) < 0.05, `${at}`);
  // It was touched last: its handle is a third of the way to the next, dragged upward.
  const handle = await page.evaluate(() => window.frond.view.tool.handles(window.frond.view.tool.stroke)[0].at.toArray());
  await drag(page, await pixelOf(page, handle), await pixelOf(page, [handle[0], handle[1] + 0.5, handle[2]]));
  const [first] = await location();
  assert.ok(Math.abs(first[2].out[1] - (handle[1] - at[1] + 0.5)) < 0.06, JSON.stringify(first));
  await shown(page);
  const way = await page.evaluate(() => window.frond.view.header.camera.way);
  assert.ok(Math.max(...way.map(p => p[1])) > at[1] + 0.05, 'the film goes that way');
  assert.ok((await text()).includes('// from left to right'));
  await undo();
  await undo();
  assert.equal(await text(), TEXT);

  // By the keyboard the next one is chosen.
  await page.getByTestId('draw:after').press('Enter');
  await page.getByTestId('draw:smooth').press('Enter');
  assert.ok((await location())[1][2].in);
  await page.getByTestId('view').locator('canvas').first().focus();
  await page.keyboard.press('Alt+PageUp');
  assert.deepEqual((await location())[1][1], [1, 0.7, 3]);
  await page.keyboard.press('Delete');
  assert.deepEqual((await location())[1], [2, [1, 0.7, 3]]);
  assert.deepEqual(page.faults, []);
});

test('an orbit is drawn in the view, and the end of a rail is dragged', async () => {
  const lines = () => page.evaluate(() => window.frond.view.guides.way.children.map(one => one.geometry.getAttribute('position').count));
  assert.deepEqual(await lines(), [], 'the way through the keys is drawn already');
  await open(TEXT.replace('"look_at"', '"move": {"orbit": {"turn": 360}}, "look_at"').replace('[[0, [-1, 0.6, 3]], [2, [1, 0.6, 3]]]', '[0, 0.6, 3]'));
  assert.deepEqual(await lines(), [49]);
  const way = await page.evaluate(() => window.frond.view.header.camera.way);
  for (const [x, , z] of way) assert.ok(Math.abs(Math.hypot(x, z) - 3) < 0.02, `${x} ${z}`);
  assert.ok(way.some(([, , z]) => z < -2.9), 'round the back');
  await page.getByTestId('organism:0').click();
  assert.deepEqual(await lines(), [], 'only with the scene');

  const rail = TEXT.replace('"look_at"', '"move": {"rail": {"to": [1, 0.6, 2]}}, "look_at"').replace('[[0, [-1, 0.6, 3]], [2, [1, 0.6, 3]]]', '[-1, 0.6, 2]');
  await open(rail);
  await lookAt([0, 0.6, 2]);
  await drag(page, await pixelOf(page, [1, 0.6, 2]), await pixelOf(page, [1, 1.1, 2]));
  const {to} = (await json()).scene.camera.move.rail;
  assert.ok(Math.abs(to[1] - 1.1) < 0.05, `${to}`);
  await undo();
  assert.equal(await text(), rail);
  assert.deepEqual(page.faults, []);
});
