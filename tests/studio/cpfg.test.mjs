// Plants of models of cpfg: their files are shown and edited, and the wall of variations shows their flowers.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {browse, changed, parts, preset, scratch, shown, start, visit} from './studio.mjs';

for (const name of ['lilac.l', 'lilac.v', 'lilac_petal.s', 'heart_leaf.s', 'growth.fset', 'plants.map']) fs.copyFileSync(path.join('presets/lsystems', name), path.join(scratch, name));
const TEXT = `{
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio", "camera": {"location": [0, 0.9, 3.5], "look_at": [0, 0.8, 0], "angle": 40}},
  "organisms": [{"kind": "plant", "name": "lilac", "height": 1.6, "smoothing": 1, "grammar": {"file": "lilac.l", "vary": true},
    "place": {"at": [[0, 0]], "size_variation": 0, "turn_variation": 0, "lean": 0}}]
}
`;
let page, studio;
before(async () => {
  studio = await start(preset('lilac.json', TEXT));
  page = await visit(await browse(), studio.address, {viewport: {width: 1280, height: 800}});
  await shown(page);
});
after(async () => {
  // That a text cannot be read is 422, which browsers tell of on their consoles.
  assert.deepEqual(page.faults.filter(fault => !/status of 422.*grammar\/change/.test(fault)), []);
  await studio.stop();
});

test('a model of cpfg shows its files, and an edit of one changes the picture and is undone', async () => {
  await page.getByTestId('open-grammar').click();
  const rules = page.getByTestId('grammar-file:lilac.l');
  await rules.waitFor();
  const was = fs.readFileSync(path.join(scratch, 'lilac.l'), 'utf8');
  assert.equal(await rules.inputValue(), was);
  assert.equal(await page.getByTestId('grammar-file:lilac.v').count(), 1);
  assert.ok(await page.getByTestId('axiom').isHidden(), 'what the model does not read is not offered');
  await page.waitForFunction(() => document.querySelector('[data-testid=word]')?.textContent.length > 10);

  // What cannot be read is told with its line, and nothing else happens.
  await rules.fill(was.replace('endlsystem', 'A --> (\nendlsystem'));
  await page.getByTestId('grammar-fault').getByText(/lilac\.l/).waitFor();
  assert.equal(fs.existsSync(path.join(scratch, 'lilac')), false);

  const before = await parts(page);
  await rules.fill(was.replace(/derivation length: *\d+/, 'derivation length: 2'));
  await changed(page, before);
  await shown(page);
  assert.ok(fs.existsSync(path.join(scratch, 'lilac', 'lilac.l')));
  await page.waitForFunction(() => document.querySelector('[data-testid=turtle-svg]').naturalWidth > 0);
  assert.equal(fs.readFileSync(path.join(scratch, 'lilac.l'), 'utf8'), was, 'the former stays');
  const edited = await parts(page);
  await page.getByTestId('undo').click();
  await changed(page, edited);
  await page.waitForFunction(was => document.querySelector('[data-testid="grammar-file:lilac.l"]').value === was, was);
});

test('tiles of the wall show the flowers that the chosen one has', async () => {
  await page.getByTestId('variations').click();
  await page.waitForFunction(() => document.querySelectorAll('[data-testid^="variation:"].drawn:not(.rough)').length === 9);
  // Pixels of lilac: more blue than green.
  const flowers = await page.evaluate(() => [...document.querySelectorAll('[data-testid^="variation:"] canvas')].map(canvas => {
    const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 2] > data[i + 1] + 12 && data[i] > data[i + 1] + 6) ++count;
    return count;
  }));
  console.log(`pixels of flowers: ${flowers.join(', ')}`);
  // Drawn as while something moves they have 850 to 1,450, 1,100 as a mean.
  for (const count of flowers) assert.ok(count > 1000, flowers.join());
  assert.ok(flowers.reduce((sum, count) => sum + count) / flowers.length > 1700, flowers.join());
});
