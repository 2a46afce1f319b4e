// The trees of the page to try things on, opened from the disk, against the program.
//   node trees.test.mjs FROND PACKAGES PAGE FIGURES
// PAGE is the folder of the built page, FIGURES the program of figures.cpp; for the others see ../studio/studio.mjs.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {browse, follow, load, visit} from '../studio/studio.mjs';

const address = pathToFileURL(path.join(process.argv[4], 'index.html')).href;
const figures = path.resolve(process.argv[5]);

let browser, page;
before(async () => {
  browser = await browse();
  page = await visit(browser, `${address}#tree=cherry&years=12&seed=2&season=0.5`);
});

const settled = at => at.waitForFunction(() => window.frond && !window.frond.busy());
const said = async (at, what) => {
  await settled(at);
  return at.getByTestId(`tree-${what}`).textContent();
};

/** What the page's engine grows, in figures. */
const grown = (species, seed, years) =>
  page.evaluate(async ([text, seed, years]) => {
    const {errors, segments: s, organs, height: living} = await window.frond.treeOf(text, seed, years, 0.5);
    const found = {errors, segments: s.length / 13, height: 0, sum: [0, 0, 0], radii: 0, organs: 0, living};
    for (let i = 0; i < s.length; i += 13) {
      for (let k = 0; k < 3; ++k) found.sum[k] += s[i + 4 + k];
      found.radii += s[i + 7];
      found.height = Math.max(found.height, s[i + 5]);
    }
    for (const one of organs) found.organs += one.length / 13;
    return found;
  }, [fs.readFileSync(`presets/trees/${species}.json`, 'utf8'), seed, years]);

/** The same of the program, on level ground. */
function program(species, seed, years) {
  const sets = [`/seed=${seed}`, `/organisms/0/years=${years}`, '/organisms/0/count=1', '/organisms/0/place={"at": [[0, 0]], "size_variation": 0, "lean": 0}', '/scene/floor/relief=0'];
  const done = spawnSync(figures, [`presets/trees/${species}.json`, ...sets], {encoding: 'utf8', env: {...process.env, FROND_HOME: process.cwd()}});
  assert.equal(done.status, 0, done.stderr);
  return JSON.parse(done.stdout);
}

test('trees are those of the program at every age', async () => {
  for (const [species, seed, ages] of [['oak', 3, [1, 9, 30]], ['oak', 8, [30]], ['spruce', 1, [5, 24]], ['spruce', 2, [24]],
    ['birch', 5, [20]], ['birch', 6, [20]], ['dead_tree', 3, [30]]]) {
    for (const years of ages) {
      const ours = await grown(species, seed, years), theirs = program(species, seed, years), name = `${species} ${seed}, ${years} years`;
      assert.deepEqual(ours.errors, [], name);
      assert.equal(ours.segments, theirs.segments, name);
      assert.equal(ours.organs, theirs.organs, name);
      const near = (a, b, most) => assert.ok(Math.abs(a - b) <= most, `${name}: ${a}, not ${b}`);
      near(ours.height, theirs.height, 1e-5 * theirs.height);
      near(ours.radii, theirs.radii, 1e-4 * theirs.radii);
      for (let k = 0; k < 3; ++k) near(ours.sum[k], theirs.sum[k], 1e-5 * theirs.segments * theirs.height);
    }
  }
});

test('a year, another season and another seed are shown', async () => {
  assert.match(await said(page, 'figures'), /^\d\.\d m high, stem of \d+ cm, [\d,]+ internodes; grown in \d+\.\d s$/);
  const summer = await page.getByTestId('tree-view').screenshot();
  await page.getByTestId('time').fill('0');
  const same = await said(page, 'figures');
  assert.equal(await page.getByTestId('month').textContent(), 'January');
  const winter = await page.getByTestId('tree-view').screenshot();
  assert.ok(!summer.equals(winter));
  await page.getByTestId('tree-reseed').click();
  assert.notEqual(await said(page, 'figures'), same);
  await page.getByTestId('years').fill('20');
  assert.notEqual(await said(page, 'figures'), same);
  await page.getByTestId('years').fill('9999');
  await settled(page);
  assert.equal(await page.getByTestId('years-slider').inputValue(), '30');
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByTestId('tree-png').click()]);
  assert.ok(fs.statSync(await download.path()).size > 20_000);
});

test('a link carries the tree', async () => {
  await page.getByTestId('years').fill('14');
  await page.getByTestId('time').fill('0.8');
  await page.waitForTimeout(600);
  const other = await visit(browser, page.url());
  await settled(other);
  for (const name of ['species', 'years', 'tree-seed', 'time', 'years-slider'])
    assert.equal(await other.getByTestId(name).inputValue(), await page.getByTestId(name).inputValue(), name);
  assert.equal((await said(other, 'figures')).split(';')[0], (await said(page, 'figures')).split(';')[0]);
  await follow(other, `${address}#tree=nothing&years=-3&seed=x&season=7`);
  assert.equal(await said(other, 'faults'), '');
  assert.equal(await other.getByTestId('species').inputValue(), 'oak');
  assert.deepEqual(other.faults, []);
  await other.close();
});

test('it grows by itself, turns by keys, and everybody can use it', async () => {
  await page.getByTestId('tree-grow').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="years"]').value < 13);
  await page.waitForFunction(() => document.querySelector('[data-testid="years"]').value === '14');
  await settled(page);
  const canvas = page.getByTestId('tree-view');
  await page.getByTestId('species').focus();
  const reached = [];
  for (let i = 0; i < 12 && !reached.includes('link'); ++i) {
    reached.push(await page.evaluate(() => document.activeElement?.dataset.testid));
    await page.keyboard.press('Tab');
  }
  for (const name of ['species', 'years-slider', 'years', 'tree-grow', 'time', 'tree-reseed', 'tree-seed', 'tree-view']) assert.ok(reached.includes(name), `${name} of ${reached}`);
  await canvas.focus();
  const before = await canvas.screenshot();
  for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowLeft');
  assert.ok(!before.equals(await canvas.screenshot()));
  await page.addScriptTag({content: fs.readFileSync(load.resolve('axe-core/axe.min.js'), 'utf8')});
  const {violations} = await page.evaluate(() => window.axe.run({preload: false}));
  assert.deepEqual(violations.map(one => one.help), []);
  await page.getByTestId('to-grammars').click();
  await page.getByTestId('rules').waitFor();
  await page.getByTestId('to-trees').click();
  await canvas.waitFor();
  assert.equal(await page.getByTestId('years').inputValue(), '14');
  assert.deepEqual(page.faults, []);
});
