// The corals of the page to try things on, opened from the disk, against the program; and what the page hands to it.
//   node corals.test.mjs FROND PACKAGES PAGE FIGURES JUDGE
// PAGE is the folder of the built page, FIGURES the program of figures.cpp, JUDGE a folder whose node_modules have gltf-validator;
// for the others see ../studio/studio.mjs.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import {before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {browse, follow, frond, load, preset, visit} from '../studio/studio.mjs';

const address = pathToFileURL(path.join(process.argv[4], 'index.html')).href;
const figures = path.resolve(process.argv[5]);
const judge = createRequire(path.join(path.resolve(process.argv[6]), 'node_modules/'))('gltf-validator');
const home = {...process.env, FROND_HOME: process.cwd()};

let browser, page;
before(async () => {
  browser = await browse();
  page = await visit(browser, `${address}#coral=lobe`);
});

const settled = at => at.waitForFunction(() => window.frond && !window.frond.busy());
const said = async (at, what) => {
  await settled(at);
  return at.getByTestId(`coral-${what}`).textContent();
};
async function saved(name) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByTestId(name).click()]);
  return {name: download.suggestedFilename(), bytes: fs.readFileSync(await download.path())};
}

/** What the page's engine grows, in figures. */
const grown = (text, name) =>
  page.evaluate(async ([text, name]) => {
    const {errors, segments: s, places, corners} = await window.frond.coralOf(text, name, 1, 1);
    if (errors.length) return {errors};
    const found = {errors, segments: s.length / 13, sum: [0, 0, 0], radii: 0, triangles: corners.length / 3, vertices: places.length / 3, places: [0, 0, 0]};
    for (let i = 0; i < s.length; i += 13) {
      for (let k = 0; k < 3; ++k) found.sum[k] += s[i + 4 + k];
      found.radii += s[i + 7];
    }
    for (let i = 0; i < places.length; ++i) found.places[i % 3] += places[i];
    return found;
  }, [text, name]);

/** The same of the program, upright on level ground. */
function program(species) {
  const sets = ['/organisms/0/count=1', '/organisms/0/place={"at": [[0, 0]], "size_variation": 0, "lean": 0, "turn_variation": 0, "rock": 0}', '/scene/floor/relief=0'];
  const done = spawnSync(figures, [`presets/species/corals/${species}.json`, ...sets], {encoding: 'utf8', env: home});
  assert.equal(done.status, 0, done.stderr);
  return JSON.parse(done.stdout);
}

test('corals are those of the program', async () => {
  const listed = await page.getByTestId('coral').locator('option').evaluateAll(all => all.map(one => one.value));
  assert.ok(listed.length >= 20, listed.join());
  for (const species of listed) {
    const ours = await grown(fs.readFileSync(`presets/species/corals/${species}.json`, 'utf8'), `${species}.json`), theirs = program(species);
    assert.deepEqual(ours.errors, [], species);
    for (const count of ['segments', 'triangles', 'vertices']) assert.equal(ours[count], theirs[count], `${count} of ${species}`);
    const near = (a, b, most) => assert.ok(Math.abs(a - b) <= most, `${species}: ${a}, not ${b}`);
    near(ours.radii, theirs.radii, 1e-4 * theirs.radii);
    for (const k of [0, 2]) {  // the foot is a little in the ground
      near(ours.sum[k], theirs.sum[k], 1e-4 * theirs.segments);
      near(ours.places[k], theirs.places[k], 1e-4 * theirs.vertices);
    }
  }
});

test('sliders, lists and colours change the preset, and comments stay', async () => {
  await follow(page, `${address}#coral=brain`);
  const first = await said(page, 'figures');
  assert.match(first, /^36 × 3\d cm, 2\d cm high; grown in \d+\.\d s$/);
  const before = await page.getByTestId('coral-view').screenshot();
  await page.getByTestId('coral-height').fill('0.1');
  assert.match(await said(page, 'figures'), /1\d cm high/);
  await page.getByTestId('coral-relief').selectOption('plain');
  await page.getByTestId('coral-tissue-color').fill('#d04080');
  await settled(page);
  assert.ok(!before.equals(await page.getByTestId('coral-view').screenshot()));
  await page.getByText('Preset', {exact: true}).click();
  const text = await page.getByTestId('coral-text').inputValue();
  assert.match(text, /\/\/ Pseudodiploria: a dome of long valleys/);
  assert.match(text, /"height": 0\.1,/);
  assert.match(text, /"color": "#d04080"/);
  await page.getByTestId('coral-across-slider').focus();
  await page.keyboard.press('ArrowRight');
  assert.notEqual(await page.getByTestId('coral-text').inputValue(), text);
  await page.getByTestId('coral-reseed').click();
  assert.match(await page.getByTestId('coral-text').inputValue(), /"seed": 5,/);
});

test('what is wrong is told as the program tells it', async () => {
  const box = page.getByTestId('coral-text');
  await follow(page, `${address}#coral=brain`);
  await settled(page);
  const right = await box.inputValue();
  for (const [from, to] of [['"across": 0.36', '"acros": 0.36'], ['"height": 0.21', '"height": 9'], ['"lumps": 0.12', '"lumps": "much"'], [/"edge": [\d.]+/, '"edge": 0.1'], ['#a98a4c', '#a98a4']]) {
    const text = right.replace(from, to);
    assert.notEqual(text, right);
    await box.fill(text);
    await settled(page);
    const told = await page.getByTestId('coral-faults').locator('p:not(.note)').allTextContents();
    const done = spawnSync(frond, ['check', preset('my_brain.json', text)], {encoding: 'utf8', env: home});
    assert.equal(done.status, 2, to);
    assert.deepEqual(told, done.stderr.trim().split('\n').map(line => line.replace(/^.*?(?=my_brain\.json)/, '')), to);
    assert.ok(await page.locator('.numbers .wrong').count(), to);
  }
  await box.fill(right);
  assert.equal(await said(page, 'faults'), '');
});

test('it grows by itself, and a link carries it', async () => {
  await page.getByTestId('coral').selectOption('staghorn');
  await settled(page);
  const all = await page.getByTestId('coral-view').screenshot();
  await page.getByTestId('coral-growth').fill('0.4');
  await settled(page);
  assert.ok(!all.equals(await page.getByTestId('coral-view').screenshot()));
  await page.getByTestId('coral-grow').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="coral-growth"]').value < 0.4);
  await page.waitForFunction(() => document.querySelector('[data-testid="coral-growth"]').value === '1');
  await page.getByTestId('coral-steps').fill('3');
  await settled(page);
  await page.waitForTimeout(600);
  const other = await visit(browser, page.url());
  await settled(other);
  assert.equal(await other.getByTestId('coral-steps').inputValue(), '3');
  assert.equal((await said(other, 'figures')).split(';')[0], (await said(page, 'figures')).split(';')[0]);
  await follow(other, `${address}#coral=nothing&preset=bm90aGluZw`);
  await settled(other);
  assert.equal(await said(other, 'faults'), '');
  assert.equal(await other.getByTestId('coral').inputValue(), 'cauliflower');
  assert.deepEqual(other.faults, []);
  await other.close();
});

test('presets of all three are handed to the program', async () => {
  const hand = async (kind, expected) => {
    await settled(page);
    const {name, bytes} = await saved(`${kind}-preset`);
    assert.equal(name, `${expected}.json`);
    assert.equal(await page.getByTestId(`${kind}-command`).textContent(), `frond render ${name}`);
    await page.getByTestId(`${kind}-handed`).filter({hasText: `${name} is among your downloads`}).waitFor();
    const done = spawnSync(frond, ['check', preset(name, bytes)], {encoding: 'utf8', env: home});
    assert.equal(done.status, 0, `${name}: ${done.stderr}`);
    assert.equal(done.stderr, '', name);
    return bytes.toString();
  };
  await follow(page, `${address}#coral=staghorn`);
  await page.getByTestId('coral-steps').fill('3');
  assert.match(await hand('coral', 'my_staghorn'), /"steps": 3/);
  for (const species of await page.getByTestId('coral').locator('option').evaluateAll(all => all.slice(0, 6).map(one => one.value))) {
    await page.getByTestId('coral').selectOption(species);
    await hand('coral', `my_${species}`);
  }
  await follow(page, `${address}#tree=cherry&years=9&seed=5&season=0.8`);
  const tree = JSON.parse((await hand('tree', 'my_cherry')).replace(/^\s*\/\/.*$/gm, ''));
  assert.equal(tree.seed, 5);
  assert.equal(tree.organisms[0].years, 9);
  assert.equal(tree.organisms[0].season.at, 0.8);
  assert.deepEqual(tree.scene.camera.fit, ['all']);
  await follow(page, address);
  for (const grammar of ['bush', 'koch_island', 'plant_d', 'palm', 'hilbert_3d', 'crocus', 'tropism_b']) {
    await page.getByTestId('example').selectOption(grammar);
    await hand('grammar', `my_${grammar}`);
  }
  await page.getByTestId('axiom').fill('F');
  await page.getByTestId('rules').fill('F -> F[+F]F');
  await hand('grammar', 'my_plant');
});

test('what is seen is saved as GLB', async () => {
  const glb = async (test, least) => {
    await settled(page);
    const {bytes} = await saved(test);
    const {issues, info} = await judge.validateBytes(new Uint8Array(bytes));
    assert.equal(issues.numErrors + issues.numWarnings, 0, `${test}: ${JSON.stringify(issues.messages.slice(0, 3))}`);
    assert.ok(info.totalTriangleCount >= least, `${test}: ${info.totalTriangleCount} triangles`);
    return info.totalTriangleCount;
  };
  await follow(page, `${address}#coral=brain`);
  const {triangles} = await grown(fs.readFileSync('presets/species/corals/brain.json', 'utf8'), 'brain.json');
  assert.equal(await glb('coral-glb', 1000), triangles);
  await page.getByTestId('coral').selectOption('sea_fan');
  await glb('coral-glb', 10_000);
  await follow(page, `${address}#tree=cherry&years=9`);
  await glb('tree-glb', 5000);
  await follow(page, address);
  await glb('save-glb', 5000);
});

test('everybody can use it', async () => {
  await follow(page, `${address}#coral=organ_pipe_coral`);
  await settled(page);
  await page.addScriptTag({content: fs.readFileSync(load.resolve('axe-core/axe.min.js'), 'utf8')});
  for (const link of ['to-corals', 'to-trees', 'to-grammars']) {
    await page.getByTestId(link).click();
    await settled(page);
    const {violations} = await page.evaluate(() => window.axe.run({preload: false}));
    assert.deepEqual(violations.map(one => one.help), [], link);
  }
  // Nothing is wider than a phone.
  await page.setViewportSize({width: 390, height: 844});
  for (const link of ['to-corals', 'to-trees', 'to-grammars']) {
    await page.getByTestId(link).click();
    await settled(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 390 && document.body.scrollWidth <= 390), link);
  }
  assert.deepEqual(page.faults, []);
});
