// One's own files: found in the gallery, watched while they are open, and none of it lost with server or tab.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {TEXT} from './plant.mjs';
import {browse, preset, scratch, shown, start, visit, visitIn} from './studio.mjs';

let browser, file, studio;
before(async () => {
  browser = await browse();
  file = preset('plant.json', TEXT);
  preset('other.json', TEXT.replace('A test', 'Another of mine'));
  preset('unfinished.json', TEXT.replace('"kind": "plant"', '"kind": "plannt"'));
  studio = await start(file);
});
after(() => studio.stop());

const number = page => page.locator('[data-testid="row:organism/height"] input.number');
async function set(page, value) {
  await number(page).fill(String(value));
  await number(page).press('Enter');
  await page.getByTestId('unsaved').waitFor();
}

test('own files are opened from the gallery, as themselves', async () => {
  const page = await visit(browser, studio.address);
  await shown(page);
  await page.getByTestId('to-gallery').click();
  await page.getByTestId('own:other.json').click();
  await shown(page);
  assert.equal(await page.getByTestId('file').textContent(), 'other.json');
  await set(page, 1.5);
  await page.getByTestId('save').click();
  await page.getByText(/^Saved /).waitFor();
  assert.match(fs.readFileSync(path.join(scratch, 'other.json'), 'utf8'), /"height": 1.5/);
  await page.context().close();
});

test('Enter in Save as saves once, and leaves the keyboard where it was', async () => {
  const page = await visit(browser, studio.address);
  await shown(page);
  await page.getByTestId('save-as-button').focus();
  await page.keyboard.down('Enter');
  await page.keyboard.up('Enter');
  await page.getByTestId('save-name').fill('entered');
  // Held down, as a person's finger may.
  for (let i = 0; i < 3; ++i) await page.keyboard.down('Enter');
  await page.getByText(/^Saved /).waitFor();
  assert.equal(await page.getByTestId('save-as').count(), 0);
  await page.keyboard.up('Enter');
  assert.equal(await page.getByTestId('save-as').count(), 0, 'it does not open again');
  assert.equal(await page.evaluate(() => document.activeElement?.dataset.testid), 'save-as-button');
  assert.ok(fs.existsSync(path.join(scratch, 'entered.json')));
  await page.context().close();
});

test('a card without a picture in the gallery shows a quick look', async () => {
  const page = await visit(browser, studio.address);
  await shown(page);
  await page.getByTestId('to-gallery').click();
  await page.getByTestId('gallery-search').fill('species/corals/finger');
  const picture = page.getByTestId('card:species/corals/finger').locator('img');
  await picture.waitFor();
  await page.waitForFunction(() => document.querySelector('[data-testid="card:species/corals/finger"] img')?.naturalWidth > 100);
  await page.context().close();
});

test('a file that no picture can be made of has a card all the same, and is no fault on the console', async () => {
  const page = await visit(browser, studio.address);
  await shown(page);
  await page.getByTestId('to-gallery').click();
  await page.getByTestId('own:unfinished.json').locator('.blank').waitFor();
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('what another program writes is noticed, and taken where it is wanted', async () => {
  const page = await visit(browser, studio.address);
  await shown(page);
  fs.writeFileSync(file, TEXT.replace('"height": 1,', '"height": 2.5,'));
  await page.getByTestId('changed').waitFor();
  await page.getByTestId('answer:load').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="row:organism/height"] input.number')?.value === '2.5');
  assert.ok(await page.getByTestId('unsaved').isHidden());
  // Once more, and not wanted: one is told when one saves.
  await set(page, 3);
  fs.writeFileSync(file, TEXT);
  await page.getByTestId('changed').waitFor();
  await page.getByTestId('answer:keep').click();
  assert.equal(await number(page).inputValue(), '3');
  await page.getByTestId('save').click();
  await page.getByTestId('save-conflict').waitFor();
  await page.context().close();
});

test('the address that a server started anew prints is pasted into the tab, which goes on', async () => {
  const own = preset('pasted.json', TEXT);
  let server = await start(own);
  const page = await visit(browser, server.address);
  await shown(page);
  await set(page, 1.25);
  await server.stop();
  const banner = page.getByTestId('banner');
  await banner.getByText('does not answer').waitFor();
  server = await start(own, '--port', String(server.port));
  await banner.getByText('Open the address').waitFor();
  await page.goto(server.address);
  await banner.waitFor({state: 'hidden'});
  await shown(page);
  assert.equal(await number(page).inputValue(), '1.25');
  await page.context().close();
  await server.stop();
});

test('a tab that is opened with the new address lets the old one in again', async () => {
  const own = preset('two.json', TEXT);
  let server = await start(own);
  const page = await visit(browser, server.address);
  await shown(page);
  await set(page, 1.25);
  await server.stop();
  server = await start(own, '--port', String(server.port));
  await page.getByTestId('banner').getByText('Open the address').waitFor();
  const other = await visitIn(page.context(), server.address);
  await shown(other);
  await page.getByTestId('banner').waitFor({state: 'hidden'});
  assert.equal(await number(page).inputValue(), '1.25');
  assert.equal(await other.getByTestId('left').count(), 0, 'the old tab still has it');
  await page.context().close();
  await server.stop();
});

test('a new tab offers what one that is gone had not saved', async () => {
  const page = await visit(browser, studio.address);
  await shown(page);
  await set(page, 1.75);
  const context = page.context();
  // The text is kept after a moment.
  await page.waitForFunction(() => Object.keys(localStorage).some(key => localStorage[key].includes('1.75')));
  await page.close();
  const next = await visitIn(context, studio.address);
  await next.getByTestId('left').waitFor();
  await next.getByTestId('answer:go-on').click();
  await shown(next);
  assert.equal(await number(next).inputValue(), '1.75');
  await context.close();
});
