// The studio's page is for everybody: axe-core finds nothing to complain of.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import {before, test} from 'node:test';
import {TEXT} from './plant.mjs';
import {browse, load, preset, shown, start, visit} from './studio.mjs';

const AXE = fs.readFileSync(load.resolve('axe-core/axe.min.js'), 'utf8');
let browser, gallery, studio;
before(async () => {
  browser = await browse();
  gallery = await start();
  studio = await start(preset('plant.json', TEXT));
});

/** Nothing that axe-core calls a violation. */
async function accessible(page, what) {
  await page.evaluate(AXE);
  const {violations} = await page.evaluate(() => window.axe.run(document, {resultTypes: ['violations']}));
  const said = violations.flatMap(v => v.nodes.map(node => `${v.id}: ${node.target} ${node.failureSummary}`));
  assert.deepEqual(said, [], what);
}

test('the editor on a phone, with its tools, its sheet and a menu', async () => {
  const page = await visit(browser, studio.address, {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true});
  await shown(page);
  for (const tool of ['place', 'branches', 'draw', 'paint', 'measure', 'select']) {
    await page.getByTestId(`tool:${tool}`).click();
    await accessible(page, tool);
  }
  await page.getByTestId('side').click();
  await accessible(page, 'properties');
  await page.getByTestId('more-acts').click();
  await accessible(page, 'more');
  await page.context().close();
});

for (const colorScheme of ['light', 'dark']) {
  test(`the gallery, ${colorScheme}`, async () => {
    const page = await visit(browser, gallery.address, {colorScheme});
    await page.locator('[data-testid^="card:"]').first().waitFor();
    await accessible(page, 'gallery');
    await page.context().close();
  });

  test(`the editor and its dialogs, ${colorScheme}`, async () => {
    const page = await visit(browser, studio.address, {colorScheme});
    await shown(page);
    await accessible(page, 'editor');
    for (const tab of ['problems', 'grammar', 'text', 'film', 'renders']) {
      await page.getByTestId(`tab:${tab}`).click();
      await accessible(page, tab);
    }
    for (const part of ['part:scene', 'part:preset', 'part:all']) {
      await page.getByTestId(part).click();
      await accessible(page, part);
    }
    for (const [button, dialog] of [['add-organism', 'add'], ['save-as-button', 'save-as']]) {
      await page.getByTestId(button).click();
      await page.getByTestId(dialog).waitFor();
      await accessible(page, dialog);
      await page.keyboard.press('Escape');
    }
    await page.getByTestId('variations').click();
    await page.locator('[data-testid^="variation:"]').first().waitFor();
    await accessible(page, 'variations');
    await page.context().close();
  });
}
