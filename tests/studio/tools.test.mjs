// What a person does with the tools of the view: a real server, a real browser, a real mouse, and the keyboard.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {before, beforeEach, afterEach, test} from 'node:test';
import {browse, changed, drag, parts, pixelOf, preset, scratch, shown, start, visit} from './studio.mjs';

const TEXT = `// A garden to work in.
{
  "seed": 3,
  "film": {"frames": 24, "fps": 12, "size": [160, 120]},
  "scene": {
    "setting": "garden", // level
    "camera": {"location": [0, 6, 9], "look_at": [0, 0, 0], "angle": 50},
    "meadow": {"blade": 0}, "floor": {"relief": 0}
  },
  "organisms": [
    {"kind": "plant", "name": "herb", "height": 1, "count": 2, "place": {"at": [[-2, 0], [2, 0]], "size_variation": 0, "turn_variation": 0, "lean": 0},
     "grammar": {"axiom": "A", "steps": 3, "angle": 25, "rules": ["A -> F[+A][-A]FA", "F -> FF"]}},
    /* What it climbs. */
    {"kind": "wall", "name": "wall", "width": 3, "height": 1.6, "thickness": 0.3, "ruin": 0, "place": {"at": [[0, -3]], "turn_variation": 0, "lean": 0, "size_variation": 0}},
    {"kind": "ivy", "name": "ivy", "on": ["wall"], "count": 2, "crawl": {"max_age": 5}},
    {"kind": "colonized", "name": "crown", "count": 1, "colonize": {"attractors": 150}, "envelope": {"height": 1.5, "width": 1}, "place": {"at": [[4, -1]], "size_variation": 0, "lean": 0}},
    {"kind": "plant", "name": "daisies", "height": 0.2, "count": 40, "sown": {"models": 1, "where": {"layer": "herbs", "radius": 0.1}},
     "grammar": {"axiom": "F[+F][-F]"}}
  ]
}
`;
let browser, file, page, studio;
before(async () => (browser = await browse()));
beforeEach(async () => {
  file = preset('tools.json', TEXT);
  studio = await start(file);
  page = await visit(browser, studio.address, {viewport: {width: 1280, height: 800}});
  await shown(page);
});
afterEach(async () => {
  assert.deepEqual(page.faults, []);
  await page.context().close();
  await studio.stop();
});

const tool = name => page.getByTestId(`tool:${name}`).click();
const select = entry => page.getByTestId(`organism:${entry}`).click();
/** The preset as it is now, without its comments. */
const now = async () => {
  await page.getByTestId('tab:text').click();
  const text = await page.getByTestId('text').inputValue();
  await page.getByTestId('tab:text').click();
  return {text, json: JSON.parse(text.replace(/\/\*.*?\*\/|(^|\s)\/\/.*$/gm, ''))};
};
/** Resolves when the text is another than that. */
async function after(act) {
  const text = () => page.evaluate(() => JSON.parse(sessionStorage.getItem('frond.draft')).text);
  await page.evaluate(() => dispatchEvent(new Event('pagehide')));
  const was = await text();
  await act();
  await page.waitForFunction(was => {
    dispatchEvent(new Event('pagehide'));
    return JSON.parse(sessionStorage.getItem('frond.draft')).text !== was;
  }, was);
  return now();
}
/** Drags through places of the world. */
const dragOver = async (...places) => drag(page, ...(await Promise.all(places.map(at => pixelOf(page, at)))));
const near = (a, b, within) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) < within, `${a} is not ${b}`));

test('a path and a bed are drawn on the ground, their points dragged, and undone', async () => {
  await tool('draw');
  await page.getByTestId('draw-what').selectOption('path');
  await page.getByTestId('draw-width').fill('80cm');
  let {json, text} = await after(() => dragOver([-3, 0, 2], [0, 0, 3], [3, 0, 2]));
  const {points, width} = json.scene.garden.path;
  near(points[0], [-3, 2], 0.1);
  near(points.at(-1), [3, 2], 0.1);
  assert.ok(points.some(p => Math.hypot(p[0], p[1] - 3) < 0.2) && points.length < 12, JSON.stringify(points));
  assert.equal(width, 0.8);
  assert.ok(text.includes('// level') && text.includes('/* What it climbs. */'));

  await shown(page);
  ({json} = await after(() => dragOver([...points[0].slice(0, 1), 0, points[0][1]], [-3.5, 0, 1])));
  near(json.scene.garden.path.points[0], [-3.5, 1], 0.1);

  await shown(page);
  await page.getByTestId('draw-what').selectOption('bed');
  ({json} = await after(() => dragOver([-1, 0, 1], [1, 0, 1], [1, 0, 2], [-1, 0, 2])));
  const [{kind, outline}] = json.scene.garden.areas;
  assert.equal(kind, 'earth');
  assert.ok(outline.length >= 4);
  near(outline[0], [-1, 1], 0.1);
  await shown(page);
  while (await page.getByTestId('undo').isEnabled()) await page.getByTestId('undo').click();
  assert.equal((await now()).text, TEXT);
});

test('the camera goes along a way', async () => {
  await tool('draw');
  await page.getByTestId('draw-what').selectOption('way');
  const {json} = await after(() => dragOver([-2.5, 0, 3], [2.5, 0, 3]));
  const keys = json.scene.camera.location;
  assert.equal(keys[0][0], 0);
  assert.ok(Math.abs(keys.at(-1)[0] - 23 / 12) < 0.01);
  near(keys[0][1], [-2.5, 1.6, 3], 0.15);
});

test('a guide is drawn for a crown, in its own axes, and by the keyboard', async () => {
  await select(3);
  await tool('draw');
  await page.getByTestId('draw-what').selectOption('guide');
  let {json} = await after(() => dragOver([4, 0.2, -1], [4.6, 1, -1], [4.2, 2, -1]));
  const {points} = json.organisms[3].guide;
  assert.ok(points.length >= 3);
  const heights = points.map(p => p[1]);
  assert.ok(heights.at(-1) > 1 && heights.every((h, i) => !i || h > heights[i - 1] - 0.05), JSON.stringify(points));
  await shown(page);

  await page.getByTestId('view').locator('canvas').focus();
  ({json} = await after(async () => {
    for (let i = 0; i < 3; ++i) {
      await page.keyboard.press('Enter');
      await page.keyboard.press('Shift+ArrowUp');
      await page.evaluate(() => window.frond.view.drawn());
    }
    await page.getByTestId('draw-finish').press('Enter');
  }));
  assert.notDeepEqual(json.organisms[3].guide.points, points);
});

test('strands follow a stroke over their wall', async () => {
  await select(2);
  await tool('draw');
  await page.getByTestId('draw-what').selectOption('strand');
  const was = await parts(page);
  const {json} = await after(() => dragOver([-1, 0.4, -2.85], [0, 1.2, -2.85], [1, 0.4, -2.85]));
  const [{width, points}] = json.organisms[2].crawl.guides;
  assert.equal(width, 0.1);
  for (const [, , z] of points) assert.ok(Math.abs(z + 2.85) < 0.03, `${z} is not on the wall`);
  near(points[0], [-1, 0.4, -2.85], 0.1);
  await changed(page, was);
});

test('plantings are moved, turned, scaled, copied, scattered and taken away', async () => {
  await select(0);
  await tool('place');
  let {json} = await after(() => dragOver([-2, 0, 0], [-2, 0, 1.5]));
  near(json.organisms[0].place.at[0], [-2, 1.5], 0.1);
  await shown(page);
  // The ring's handle lies in front of it, the other above.
  const handle = async which => {
    await page.evaluate(() => window.frond.view.drawn());
    return page.evaluate(which => window.frond.view.tool.handles()[which].toArray(), which);
  };
  const [foot, turn] = [[-2, 0, 1.5], await handle(0)];
  ({json} = await after(() => dragOver(turn, [foot[0] + turn[2] - foot[2], 0, foot[2]])));
  assert.ok(Math.abs(json.organisms[0].place.each[0].turn - 90) < 4, JSON.stringify(json.organisms[0].place.each));
  await shown(page);
  const size = await handle(1);
  ({json} = await after(() => dragOver(size, [size[0], 2 * size[1], size[2]])));
  assert.ok(Math.abs(json.organisms[0].place.each[0].size - 2) < 0.2, JSON.stringify(json.organisms[0].place.each));
  await shown(page);
  ({json} = await after(() => page.getByTestId('place:copy').click()));
  assert.equal(json.organisms[0].place.at.length, 3);
  assert.equal(json.organisms[0].count, 3);
  await page.getByTestId('view').locator('canvas').focus();
  ({json} = await after(() => page.keyboard.press('Delete')));
  assert.equal(json.organisms[0].place.at.length, 2);
  await page.getByTestId('place-brush').check();
  ({json} = await after(() => dragOver([-3, 0, 3], [3, 0, 3])));
  const {at} = json.organisms[0].place;
  assert.ok(at.length > 4);
  for (const a of at) for (const b of at) assert.ok(a === b || Math.hypot(a[0] - b[0], a[1] - b[1]) > 0.69);
  await shown(page);
});

test('a tool that no picture has shown yet is pressed where its handles are', async () => {
  await select(0);
  const [foot, aside] = await Promise.all([pixelOf(page, [-2, 0, 0]), pixelOf(page, [-2, 0, 1.5])]);
  const {json} = await after(() =>
    page.evaluate(([from, to]) => {
      const {canvas} = window.frond.view;
      const at = (type, [clientX, clientY], buttons) =>
        canvas.dispatchEvent(new PointerEvent(type, {clientX, clientY, buttons, button: type === 'pointermove' ? -1 : 0, pointerId: 1, isPrimary: true, bubbles: true}));
      canvas.setPointerCapture = () => {};
      // All in one task: nothing is drawn between.
      document.querySelector('[data-testid="tool:place"]').click();
      at('pointerdown', from, 1);
      at('pointermove', to, 1);
      at('pointerup', to, 0);
    }, [foot, aside]));
  near(json.organisms[0].place.at[0], [-2, 1.5], 0.1);
});

test('metres are measured', async () => {
  await tool('measure');
  for (const at of [[-1, 0, 2], [2, 0, 2]]) await page.mouse.click(...(await pixelOf(page, at)));
  await page.getByTestId('measured').getByText(/^(2\.9\d|3\.0\d) m; across/).waitFor();
});

test('where something is sown is painted', async () => {
  await select(4);
  await tool('paint');
  await page.getByTestId('painted').getByText(/^Paint where daisies/).waitFor();
  let {json} = await after(() => page.getByTestId('paint:none').click());
  const first = json.organisms[4].sown.where.map;
  await shown(page);
  const was = await parts(page);
  ({json} = await after(() => dragOver([-3, 0, 3], [3, 0, 3])));
  const map = json.organisms[4].sown.where.map;
  assert.notEqual(map, first);
  assert.equal(fs.readFileSync(path.join(scratch, map)).subarray(1, 4).toString(), 'PNG');
  await changed(page, was);
  await shown(page);
  const rows = await page.evaluate(() => window.frond.view.header.entries[4].low[2]);
  assert.ok(rows > -1, 'none grows far from the stroke');
});

test('the scene is exported, and the view saved as a picture', async () => {
  await page.getByTestId('export').click();
  await page.getByRole('menuitem', {name: /glTF/}).click();
  const said = await page.getByText(/^Written: .*tools-1\.glb$/).textContent();
  assert.equal(fs.readFileSync(said.replace('Written: ', '')).subarray(0, 4).toString(), 'glTF');
  await page.getByTestId('export').click();
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('menuitem', {name: /picture/}).click()]);
  assert.equal(file.suggestedFilename(), 'tools.png');
  assert.equal(fs.readFileSync(await file.path()).subarray(1, 4).toString(), 'PNG');
});
