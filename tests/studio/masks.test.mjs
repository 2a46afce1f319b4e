// Masks painted on a wall and smooth lines with handles: a real server, a real browser, a real mouse.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {before, beforeEach, afterEach, test} from 'node:test';
import {browse, changed, drag, parts, pixelOf, preset, scratch, shown, start, visit} from './studio.mjs';

const TEXT = `{
  "seed": 3,
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio", "camera": {"location": [0, 1, 5], "look_at": [0, 0.8, 0], "angle": 40}},
  "organisms": [
    {"kind": "wall", "name": "wall", "width": 2.6, "height": 1.6, "thickness": 0.3, "ruin": 0, "place": {"at": [[0, 0]], "turn_variation": 0, "lean": 0, "size_variation": 0}},
    {"kind": "ivy", "name": "ivy", "on": ["wall"], "count": 24, "crawl": {"max_age": 40, "let_go": 0}, "leaves": {"bare": 0}}
  ]
}
`;
const FACE = 0.15; // z of the wall's front
let browser, page, studio;
before(async () => (browser = await browse()));
beforeEach(async () => {
  studio = await start(preset('masks.json', TEXT));
  page = await visit(browser, studio.address, {viewport: {width: 1280, height: 800}});
  await shown(page);
  await page.getByTestId('organism:1').click();
});
afterEach(async () => {
  assert.deepEqual(page.faults, []);
  await page.context().close();
  await studio.stop();
});

const text = () =>
  page.evaluate(() => {
    dispatchEvent(new Event('pagehide'));
    return JSON.parse(sessionStorage.getItem('frond.draft')).text;
  });
/** The preset after something was done that changes it. */
async function after(act) {
  const was = await text();
  await act();
  await page.waitForFunction(was => {
    dispatchEvent(new Event('pagehide'));
    return JSON.parse(sessionStorage.getItem('frond.draft')).text !== was;
  }, was);
  return JSON.parse(await text());
}
const crawl = json => json.organisms[1].crawl;
const dragOver = async (...places) => drag(page, ...(await Promise.all(places.map(at => pixelOf(page, at)))));
const slide = (name, value) =>
  page.getByTestId(name).evaluate((slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event('input', {bubbles: true}));
  }, value);
/** The box of the ivy. */
const ivy = () => page.evaluate(() => (({low, high}) => ({low, high}))(window.frond.view.header.entries[1]));

test('ivy grows where its wall is painted, along the way one looks', async () => {
  await page.getByTestId('tool:paint').click();
  await page.getByTestId('painted').getByText(/^Paint where ivy creeps.*along z/).waitFor();
  let mask = crawl(await after(() => page.getByTestId('paint:none').click())).mask;
  assert.equal(mask.along, 'z');
  assert.equal(mask.stops, 0.5);
  assert.ok(Math.abs(mask.area[0][0] + 1.3) < 0.1 && Math.abs(mask.area[1][1] - 1.6) < 0.2, JSON.stringify(mask.area));
  await shown(page);

  const was = await parts(page);
  await slide('brush-size', Math.log10(0.12));
  const first = mask.file;
  mask = crawl(await after(() => dragOver([-0.1, 0.6, FACE], [1, 0.6, FACE]))).mask;
  assert.notEqual(mask.file, first);
  assert.equal(fs.readFileSync(path.join(scratch, mask.file)).subarray(1, 4).toString(), 'PNG');
  await changed(page, was);
  await shown(page);
  const {low, high} = await ivy();
  assert.ok(low[0] > -0.35 && high[0] < 1.25 && low[1] > 0.35 && high[1] < 0.85, JSON.stringify({low, high}));
  assert.ok(low[0] < 0.2 && high[0] > 0.7, 'it grows along the whole stroke');

  // Erased in the middle of the view by the keyboard, and undone stroke by stroke.
  await page.getByTestId('view').locator('canvas').focus();
  for (let i = 0; i < 8; ++i) await page.keyboard.press(']');
  await page.keyboard.press('x');
  assert.ok(await page.getByTestId('brush-erase').isChecked());
  const erased = crawl(await after(() => page.keyboard.press('Enter'))).mask.file;
  assert.notEqual(erased, mask.file);
  assert.equal(crawl(await after(() => page.keyboard.press('Control+z'))).mask.file, mask.file);
  assert.equal(crawl(await after(() => page.keyboard.press('Control+z'))).mask.file, first);
});

test('a stroke is smooth, leads as strongly as asked, and a handle follows the pointer', async () => {
  await page.getByTestId('tool:draw').click();
  await page.getByTestId('draw-what').selectOption('strand');
  await page.getByTestId('draw-pull').fill('0.5');
  const [guide] = crawl(await after(() => dragOver([-0.8, 0.5, FACE], [0, 1.2, FACE], [0.8, 0.5, FACE]))).guides;
  assert.equal(guide.curve, true);
  assert.equal(guide.pull, 0.5);
  await shown(page);
  const top = guide.points.findIndex(p => p[1] > 1.1);
  await page.mouse.click(...(await pixelOf(page, guide.points[top])));
  const [{at: from}] = await page.evaluate(() => {
    const {tool} = window.frond.view;
    return tool.handles(tool.stroke).filter(h => h.way === 'out').map(h => ({at: h.at.toArray()}));
  });
  const target = [guide.points[top][0] + 0.4, guide.points[top][1] + 0.2, guide.points[top][2]];
  let point = crawl(await after(() => dragOver(from, target))).guides[0].points[top];
  assert.deepEqual(point.at, guide.points[top]);
  assert.ok(Math.abs(point.out[0] - 0.4) < 0.03 && Math.abs(point.out[1] - 0.2) < 0.03, JSON.stringify(point));
  assert.equal(point.in, undefined, 'the other one is opposite to it');
  await shown(page);
  await page.getByTestId('view').locator('canvas').focus();
  point = crawl(await after(() => page.keyboard.press('Delete'))).guides[0].points[top];
  assert.deepEqual(point, guide.points[top]);
});
