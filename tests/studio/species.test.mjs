// Organisms that are of a species: its properties are seen and changed, and become one's own.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import {before, test} from 'node:test';
import {browse, preset, shown, start, visit} from './studio.mjs';

const SPECIES = `{
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio"},
  "organisms": [{"kind": "plant", "name": "herb", "height": 0.8, "place": {"at": [[0, 0]]},
    "grammar": {"axiom": "A", "steps": 3, "angle": 25, "rules": ["A -> F[+A][-A]FA", "F -> FF"]}}]
}
`;
const TEXT = `{
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio", "camera": {"location": [0, 0.7, 3], "look_at": [0, 0.5, 0], "angle": 40}},
  "organisms": [
    // Two of a species.
    {"species": "herb.json", "count": 2, "place": {"at": [[0, 0], [0.5, 0]]}} // here
  ]
}
`;

let page;
before(async () => {
  preset('herb.json', SPECIES);
  const studio = await start(preset('two.json', TEXT));
  page = await visit(await browse(), studio.address);
  await shown(page);
});

const row = name => page.getByTestId(`row:organism/${name}`);
const text = () => page.getByTestId('text').inputValue();

test('the properties of a species are seen, and a change is one\'s own', async () => {
  await page.getByTestId('tab:text').click();
  await page.getByTestId('organism:0').getByText('herb').waitFor();
  await page.getByTestId('organism:0').getByText('plant').waitFor();
  assert.equal(await row('height').locator('input.number').inputValue(), '0.8');
  assert.equal(await page.getByTestId('scope:height').textContent(), 'sp.');
  await row('height').locator('input.number').fill('1.1');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('[data-testid="scope:height"]').textContent === 'own');
  assert.equal(await text(), TEXT.replace('[0.5, 0]]}}', '[0.5, 0]]}, "height": 1.1}'));
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT);
});

test('a species becomes one\'s own', async () => {
  await page.getByTestId('make-own').click();
  const own = await text();
  assert.ok(own.includes('// Two of a species.\n') && own.includes('// here\n'));
  const {species, kind, height, grammar} = JSON.parse(own.replace(/\/\/.*/g, '')).organisms[0];
  assert.deepEqual([species, kind, height, grammar.steps], [undefined, 'plant', 0.8, 3]);
  await shown(page);
  assert.equal(await page.evaluate(() => window.frond.view.header.specimens.length), 2);
  assert.deepEqual(page.faults, []);
});

test('species stand in a list with pictures, also where those of their materials come when it is closed', async () => {
  let coming = 0;
  await page.route('**/api/picture/**', async route => {
    ++coming;
    await new Promise(resolve => setTimeout(resolve, 500));
    await route.continue().catch(() => {});
    --coming;
  });
  await page.getByTestId('species').click();
  const first = page.getByTestId('choose-species').locator('button:has(canvas)').first();
  await first.waitFor();
  const count = await page.getByTestId('choose-species').locator('button:has(canvas)').count();
  assert.equal(count, fs.readdirSync('presets/species').flatMap(kind => fs.readdirSync(`presets/species/${kind}`)).length);
  await page.waitForFunction(() => {
    const {width, height} = document.querySelector('[data-testid="choose-species"] canvas');
    return width !== 160 || height !== 120;
  });
  await page.getByTestId('species:species/shells/cone').click();
  await page.waitForFunction(() => /"kind": "shell"|shells\/cone\.json/.test(document.querySelector('[data-testid="text"]').value));
  await shown(page);
  while (coming > 0) await page.waitForTimeout(100);
  await page.waitForTimeout(200);
  assert.deepEqual(page.faults, []);
});
