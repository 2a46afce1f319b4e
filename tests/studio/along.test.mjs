// Curves along the parent: how what a branch bears changes from its foot to its tip, by handles and by keys.
import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {browse, changed, parts, preset, shown, start, visit} from './studio.mjs';

const TEXT = `{
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio", "camera": {"location": [0, 2, 8], "look_at": [0, 2, 0], "angle": 40}},
  "organisms": [
    {"kind": "weber_penn", "name": "tree", "place": {"at": [[0, 0]], "size_variation": 0, "lean": 0},
     "tree": {"scale": 4, "levels": 2, "leaves": 0, "shape": "cylindrical", "trunk": {"length": 1}, "branches": {"branches": 12, "length": 0.3, "down_angle": 70}}}
  ]
}
`;
let page;
before(async () => {
  const studio = await start(preset('along.json', TEXT));
  page = await visit(await browse(), studio.address, {viewport: {width: 1280, height: 800}});
  await shown(page);
});

test('the length of branches along the trunk is a curve with handles', async () => {
  for (const group of ['tree', 'tree/branches']) {
    const head = page.getByTestId(`group:${group}`);
    if (await head.getAttribute('aria-expanded') !== 'true') await head.click();
  }
  for (const name of ['angle', 'length', 'radius', 'branches']) {
    const points = page.getByTestId(`row:organism/tree/branches/${name}_along`).locator('.point');
    assert.equal(await points.count(), 2, name);
  }
  const row = page.getByTestId('row:organism/tree/branches/length_along');
  const before = await parts(page);
  await row.locator('.point').nth(1).focus();
  for (let i = 0; i < 5; ++i) await page.keyboard.press('Shift+ArrowDown');
  await changed(page, before);
  await shown(page);
  await page.getByTestId('tab:text').click();
  const {length_along: curve} = JSON.parse(await page.getByTestId('text').inputValue()).organisms[0].tree.branches;
  assert.equal(curve.length, 2);
  assert.deepEqual(curve[0], [0, 1]);
  assert.ok(Math.abs(curve[1][1] - 0.5) < 0.01, JSON.stringify(curve));
  assert.deepEqual(page.faults, []);
});
