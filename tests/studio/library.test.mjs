// The library: organisms that are dragged into the view, materials that are dragged onto them, and how a material looks.
import assert from 'node:assert/strict';
import {before, beforeEach, test} from 'node:test';
import {browse, pixelOf, preset, shown, start, visit} from './studio.mjs';

const TEXT = `{
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio", "camera": {"location": [0, 1.2, 3], "look_at": [0, 0.3, 0], "angle": 50}},
  "organisms": [
    {"kind": "rock", "name": "stone", "size": 0.5, "depth": 3, "place": {"at": [[0, 0]]}} // mine
  ]
}`;

let browser, page, studio;
before(async () => {
  browser = await browse();
  studio = await start(preset('library.json', TEXT));
});
beforeEach(async () => {
  await page?.context().close();
  page = await visit(browser, studio.address);
  await shown(page);
  await page.getByTestId('tab:library').click();
});
const text = () => page.evaluate(() => (dispatchEvent(new Event('pagehide')), JSON.parse(sessionStorage.getItem('frond.draft')).text));
/** Resolves when the text is as asked. */
async function until(is) {
  for (let now = await text(); !is(now); now = await text()) await page.waitForTimeout(100);
}

/** Drags a card to a place of the view. */
async function drag(card, [x, y]) {
  const box = await page.getByTestId('view').boundingBox();
  await page.getByTestId(card).dragTo(page.getByTestId('view'), {targetPosition: {x: x - box.x, y: y - box.y}});
}

test('an organism is dragged to where it stands, and added by the keyboard, as a species', async () => {
  await page.getByTestId('library-search').fill('starfish');
  await drag('library:reef/starfish', await pixelOf(page, [0.7, 0, 0.4]));
  await until(now => now.includes('starfish'));
  const said = await text();
  const {place} = JSON.parse(said.replace('// mine', '')).organisms[1], [[x, z]] = place.at;
  assert.ok(Math.hypot(x - 0.7, z - 0.4) < 0.1, said);
  assert.ok(said.includes('// mine'));
  await shown(page);
  await page.getByTestId('library:reef/starfish').press('Enter');
  await until(now => now.includes('starfish 2'));
  await page.getByTestId('undo').click();
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT);
  assert.deepEqual(page.faults, []);
});

test('a material is drawn on a ball and dragged onto what takes it', async () => {
  await page.getByTestId('library:materials').click();
  await page.getByTestId('library-search').fill('column');
  const card = page.locator('[data-testid^="library:"].card').first();
  await card.waitFor();
  await page.waitForFunction(() => document.querySelector('.library-cards img')?.naturalWidth === 160);
  await drag(await card.getAttribute('data-testid'), await pixelOf(page, [0, 0.2, 0]));
  await until(now => now !== TEXT);
  const {organisms: [stone]} = JSON.parse((await text()).replace('// mine', ''));
  assert.ok(stone.stone, JSON.stringify(stone));
  assert.equal(stone.kind, 'rock');
  await page.waitForFunction(() => document.querySelector('[data-testid=swatch]')?.naturalWidth === 160);
  await page.getByTestId('on-plant').click();
  await page.waitForFunction(() => document.querySelector('[data-testid=swatch-plant]')?.naturalWidth === 240);
  assert.deepEqual(page.faults, []);
});
