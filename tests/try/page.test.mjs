// The page to try grammars on, opened from the disk, against the program.
//   node page.test.mjs FROND PACKAGES PAGE
// PAGE is the folder of the built page; for the others see ../studio/studio.mjs.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {browse, frond, load, preset, visit} from '../studio/studio.mjs';

const address = pathToFileURL(path.join(process.argv[4], 'index.html')).href;
const ENOUGH = 5_000_000; // modules, for words that the page itself would refuse
const grammars = fs.readdirSync('presets/grammars').map(file => [file.replace('.json', ''), fs.readFileSync(path.join('presets/grammars', file), 'utf8')]);

let browser, page;
before(async () => {
  browser = await browse();
  page = await visit(browser, address);
});

const settled = at => at.waitForFunction(() => window.frond && !window.frond.busy());
const faults = async at => {
  await settled(at);
  return (await at.getByTestId('faults').textContent()) ?? '';
};

/** What the engine of the page answers. */
const ask = (call, text, steps) =>
  page.evaluate(([call, text, steps, most]) => window.frond.engine(call, text, steps, most), [call, text, steps, ENOUGH]);

/** What the program prints of a grammar. */
function say(command, text, ...options) {
  const done = spawnSync(frond, [command, preset('grammar.json', text), ...options], {encoding: 'utf8', maxBuffer: 1 << 28});
  assert.equal(done.status, 0, done.stderr);
  return done.stdout.trimEnd();
}

/** A case of the known answers as a grammar file, as in tests/corpus_test.py. */
function grammarOf(known) {
  const rule = r => {
    const text = `${r.pred}${r.cond === undefined ? '' : ` : ${r.cond}`} ->${r.prob === undefined ? '' : `(${r.prob})`} ${r.succ}`;
    return r.limit === undefined ? text : {rule: text, limit: r.limit};
  };
  const text = {axiom: known.axiom, steps: known.n, rules: known.rules.map(rule)};
  const names = {angle: 'angle_deg', constants: 'constants', ignore: 'ignore', ring: 'ring', mode: 'mode', symbols: 'multi_char_symbols', interpretation_depth: 'homomorphism_depth'};
  for (const [ours, theirs] of Object.entries(names)) if (known[theirs] != null) text[ours] = known[theirs];
  for (const [ours, theirs] of [['decomposition', 'decomposition'], ['interpretation', 'homomorphism']])
    if (known[theirs] != null) text[ours] = known[theirs].map(rule);
  return text;
}

test('words are those of frond derive', async () => {
  const known = JSON.parse(fs.readFileSync('tests/grammar/corpus.json', 'utf8')).filter(one => one.rules && one.axiom !== undefined && one.n !== undefined);
  const tried = [...grammars.map(([name, text]) => [name, JSON.parse(text)]), ...known.map(one => [one.name, grammarOf(one)])];
  assert.ok(tried.length > 120, `${tried.length} grammars`);
  for (const [name, grammar] of tried) {
    const text = JSON.stringify(grammar);
    const {errors, word} = await ask('derive', text, grammar.steps);
    assert.deepEqual(errors, [], name);
    assert.ok(word === say('derive', text), name);
  }
});

test('figures are those of frond turtle, also between steps', async () => {
  for (const [name, text] of grammars) {
    const steps = JSON.parse(text).steps - 0.375;
    const {errors, lengths} = await page.evaluate(async ([text, steps, most]) => {
      const {errors, segments: s} = await window.frond.engine('draw', text, steps, most);
      let lengths = 0;
      for (let i = 0; i < s.length; i += 8) lengths += Math.hypot(s[i + 4] - s[i], s[i + 5] - s[i + 1], s[i + 6] - s[i + 2]);
      return {errors, lengths};
    }, [text, steps, ENOUGH]);
    assert.deepEqual(errors, [], name);
    const {total_length: whole} = JSON.parse(say('turtle', text, '--steps', String(steps)));
    assert.ok(Math.abs(lengths - whole) <= 1e-4 * whole, `${name}: ${lengths}, not ${whole}`);
  }
});

test('every example is drawn', async () => {
  for (const [name] of grammars) {
    await page.getByTestId('example').selectOption(name);
    assert.equal(await faults(page), '', name);
    assert.match(await page.getByTestId('figures').textContent(), name === 'algae' || name === 'cells' ? /Nothing/ : /segments|triangles/, name);
  }
  await page.getByTestId('example').selectOption('bush');
  await settled(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByTestId('save-png').click()]);
  assert.ok(fs.statSync(await download.path()).size > 20_000);
});

test('SVG files and grammars are those of the program', async () => {
  const save = async name => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByTestId(name).click()]);
    return fs.readFileSync(await download.path(), 'utf8');
  };
  await page.getByTestId('example').selectOption('palm');
  await page.getByTestId('reseed').click();
  await settled(page);
  const grammar = await save('save-json');
  assert.equal(JSON.parse(grammar).seed, 2);
  const svg = preset('palm.svg', '');
  say('turtle', grammar, '--svg', svg);
  assert.ok((await save('save-svg')) === fs.readFileSync(svg, 'utf8'));
});

test('what is typed is drawn at once, and faults are told with their line and column', async () => {
  await page.getByTestId('example').selectOption('bracketed_plant');
  await page.getByTestId('rules').fill('\nF -> F[+F]');
  assert.equal(await faults(page), '');
  assert.equal(await page.getByTestId('figures').textContent(), '16 segments');
  await page.getByTestId('rules').fill('\nF -> F[+F\nG -> (');
  assert.match(await faults(page), /Rules, line 2: column 7: this `\[` is not closed.*Rules, line 3: column 6/);
  await page.getByTestId('rules').fill('F -> FF');
  await page.locator('summary', {hasText: 'Other properties'}).click();
  await page.getByTestId('others').fill('"width": 0.2,\n"wdith": 3');
  assert.match(await faults(page), /Other properties, line 2: unknown property "wdith"/);
  await page.getByTestId('others').fill('');
  await page.getByTestId('steps').fill('2.5');
  assert.equal(await faults(page), '');
  assert.equal(await page.getByTestId('figures').textContent(), '8 segments');
});

test('it grows by itself, and everybody can use it', async () => {
  await page.getByTestId('grow').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="steps"]').value < 2.4);
  await page.waitForFunction(() => document.querySelector('[data-testid="steps"]').value === '2.5');
  await page.getByTestId('rules').fill('F -> G(');
  assert.notEqual(await faults(page), '');
  await page.addScriptTag({content: fs.readFileSync(load.resolve('axe-core/axe.min.js'), 'utf8')});
  const {violations} = await page.evaluate(() => window.axe.run({preload: false}));
  assert.deepEqual(violations.map(one => one.help), []);
});

test('a link carries the grammar', async () => {
  await page.getByTestId('rules').fill('F -> F[-(20)F]F');
  await page.getByTestId('angle').fill('33');
  await page.waitForTimeout(600);
  const other = await visit(browser, page.url());
  await settled(other);
  for (const name of ['axiom', 'rules', 'steps', 'angle', 'seed', 'others'])
    assert.equal(await other.getByTestId(name).inputValue(), await page.getByTestId(name).inputValue(), name);
  await other.goto('about:blank');
  await other.goto(`${address}#bm90aGluZw`);
  assert.equal(await faults(other), '');
  assert.equal(await other.getByTestId('example').inputValue(), 'bush');
  assert.deepEqual(other.faults, []);
});

test('no grammar hangs the page', async () => {
  await page.getByTestId('rules').fill('F -> FF');
  await page.getByTestId('steps').fill('60');
  assert.match(await faults(page), /step 19 would have .* past the limit of 300000 modules/);
  await page.getByTestId('rules').fill('F -> BF\nB < B > B -> B');
  await page.getByTestId('steps').fill('90000');
  assert.match(await faults(page), /longer than 5 seconds/);
  await page.getByTestId('example').selectOption('plant_a');
  assert.equal(await faults(page), '');
  assert.deepEqual(page.faults, []);
});
