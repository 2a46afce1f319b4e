// What a person does in the studio, with a real server and a real browser.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import {before, beforeEach, afterEach, test} from 'node:test';
import {TEXT} from './plant.mjs';
import {browse, changed, parts, preset, shown, start, visit} from './studio.mjs';

let browser, file, page, studio;
before(async () => (browser = await browse()));
beforeEach(async () => {
  file = preset('plant.json', TEXT);
  studio = await start(file);
  page = await visit(browser, studio.address);
  await shown(page);
});
afterEach(async () => {
  await page.context().close();
  await studio.stop();
});

const slider = (page, name) => page.locator(`[data-testid="row:organism/${name}"] input[type=range]`);
const number = (page, name) => page.locator(`[data-testid="row:organism/${name}"] input.number`);

/** Moves a slider a little; answers when the model is another. */
async function nudge(page, name) {
  const was = await parts(page);
  await slider(page, name).focus();
  for (let i = 0; i < 8; ++i) await page.keyboard.press('ArrowRight');
  await changed(page, was);
}

test('a slider changes the model, undo brings it back, and saving keeps the comments', async () => {
  const was = await parts(page);
  await nudge(page, 'height');
  const height = Number(await number(page, 'height').inputValue());
  assert.ok(height > 1);
  await page.getByTestId('save').click();
  await page.getByText(/^Saved /).waitFor();
  const saved = fs.readFileSync(file, 'utf8');
  assert.equal(saved, TEXT.replace('"height": 1,', `"height": ${height},`));

  const now = await parts(page);
  while (await page.getByTestId('undo').isEnabled()) await page.getByTestId('undo').click();
  await changed(page, now);
  await shown(page);
  assert.equal(await parts(page), was);
  assert.deepEqual(page.faults, []);
});

test('numbers are reckoned, and what is none stays and is told of', async () => {
  const box = number(page, 'height'), row = page.getByTestId('row:organism/height');
  await box.fill('70cm*2');
  await box.press('Enter');
  assert.equal(await box.inputValue(), '1.4');
  await box.fill('1,5');
  await box.press('ArrowUp');
  assert.equal(await box.inputValue(), '1.6');
  await box.fill('2 feet');
  await box.press('Enter');
  await row.locator('p.fault', {hasText: 'no unit of m'}).waitFor();
  await slider(page, 'height').focus();
  assert.equal(await box.inputValue(), '2 feet');
  assert.equal(await box.getAttribute('aria-invalid'), 'true');
  await box.focus();
  await box.press('Escape');
  assert.equal(await box.inputValue(), '1.6');
  assert.equal(await row.locator('p.fault').textContent(), '');
});

test('a number is changed by a drag to the side in its box, as one step to undo', async () => {
  const box = number(page, 'height');
  await box.hover();  // it stands still
  const {x, y, width, height} = await box.boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 31, y + height / 2, {steps: 10});
  await page.mouse.up();
  assert.equal(await box.inputValue(), '1.5');
  await page.getByTestId('undo').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="row:organism/height"] input.number').value === '1');
  assert.ok(await page.getByTestId('undo').isDisabled());
});

test('the scene shows the groups of its setting alone', async () => {
  await page.getByTestId('part:scene').click();
  await page.getByTestId('group:scene/studio').waitFor();
  for (const other of ['water', 'forest', 'garden', 'meadow', 'floor']) assert.equal(await page.getByTestId(`group:scene/${other}`).count(), 0, other);
  await page.locator('[data-testid="row:scene/setting"] select').selectOption('forest');
  await page.getByTestId('group:scene/forest').waitFor();
  assert.equal(await page.getByTestId('group:scene/meadow').count(), 1, 'its clouds are those');
  assert.equal(await page.getByTestId('group:scene/water').count(), 0);
});

test('the grammar tells of its size in figures', async () => {
  await page.getByTestId('tab:grammar').click();
  const figures = page.getByTestId('derive-figures');
  await figures.getByText(/The whole: [\d,]+ symbols, [\d,]+ segments/).waitFor();
});

test('a wrong rule is told of at its place', async () => {
  const was = await parts(page);
  await page.getByTestId('tab:grammar').click();
  const rules = page.getByTestId('rules:rules');
  await rules.fill('A -> F[+A][-A]FA\nF -> F[F');
  await page.getByTestId('grammar-panel').locator('p.fault', {hasText: /^2: .+/}).waitFor();
  await page.getByTestId('tab:text').click();
  const text = await page.getByTestId('text').inputValue();
  const line = text.split('\n').findIndex(l => l.includes('F -> F[F')) + 1;
  assert.ok(line > 10);
  await page.getByTestId('tab:problems').click();
  await page.getByTestId('problems').getByRole('button', {name: `line ${line}`}).first().waitFor();
  assert.equal(await parts(page), was, 'the model stays as it was');

  await page.getByTestId('tab:grammar').click();
  await rules.fill('A -> F[+A][-A]FA\nF -> F');
  await changed(page, was);
  await page.getByTestId('problems').getByText('Nothing is wrong').waitFor({state: 'attached'});
});

test('a render comes with its picture', async () => {
  await page.getByTestId('tab:renders').click();
  await page.getByTestId('render-start').click();
  const card = page.getByTestId('renders').locator('img');
  await card.waitFor();
  await page.waitForFunction(() => document.querySelector('[data-testid="renders"] img')?.naturalWidth === 160);
});

test('a variation is picked from the wall', async () => {
  const was = await parts(page);
  await page.getByTestId('variations').click();
  const tiles = page.locator('[data-testid^="variation:"]');
  assert.equal(await tiles.count(), 9);
  await page.waitForFunction(() => document.querySelectorAll('[data-testid^="variation:"].drawn').length === 9);
  await page.getByTestId('wall-progress').waitFor({state: 'hidden'});
  assert.equal(await page.locator('[data-testid^="variation:"].rough').count(), 0, 'all are as they will be');
  await tiles.nth(4).click();
  await changed(page, was);
  await page.getByTestId('undo').click();
  await page.waitForFunction(was => window.frond.view.header.parts.map(part => part.id).join() === was, was);
});

test('two tabs do not disturb each other, and neither overwrites the other unasked', async () => {
  const other = await visit(browser, studio.address);
  await shown(other);
  const was = await parts(page);
  await Promise.all([nudge(page, 'height'), nudge(other, 'height')]);
  await nudge(other, 'height');
  await Promise.all([shown(page), shown(other)]);
  assert.notEqual(await parts(page), was);
  assert.notEqual(await parts(page), await parts(other));
  await page.getByTestId('save').click();
  await page.getByText(/^Saved /).waitFor();
  await other.getByTestId('save').click();
  await other.getByTestId('save-conflict').waitFor();
  await other.context().close();
});

