// Every preset that is shipped opens from the gallery and draws.
import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {browse, shown, start, visit} from './studio.mjs';

let page, names;
before(async () => {
  const studio = await start();
  page = await visit(await browse(), studio.address, {viewport: {width: 640, height: 420}});
  const cards = page.locator('[data-testid^="card:"]');
  await cards.first().waitFor();
  names = await cards.evaluateAll(list => list.map(card => card.dataset.testid.slice('card:'.length)));
});

/** How many pixels of a small mask are white, and how many colours the view shows. */
const seen = () =>
  page.evaluate(async () => {
    const count = async (address, of) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const pen = canvas.getContext('2d');
      pen.drawImage(image, 0, 0);
      return of(pen.getImageData(0, 0, image.width, image.height).data);
    };
    const {view} = window.frond;
    const picture = document.querySelector('[data-testid="view"] canvas').toDataURL();
    return {
      nodes: view.header.nodes,
      parts: view.header.parts.filter(part => part.kind !== 'ground').length,
      white: await count(await window.frond.mask(96, 72), data => data.filter((c, i) => i % 4 === 0 && c > 127).length),
      colors: await count(picture, data => new Set(new Uint32Array(data.buffer)).size),
    };
  });

test('every shipped preset opens and draws', async t => {
  assert.ok(names.length > 40, `${names.length} presets`);
  for (const name of names)
    await t.test(name, async () => {
      await page.getByTestId(`card:${name}`).click();
      try {
        await shown(page);
        const {nodes, parts, white, colors} = await seen();
        console.log(`${name}: ${nodes} nodes, ${parts} parts, ${white} pixels of the mask, ${colors} colours`);
        assert.ok(parts > 0 && white > 0 && colors > 100);
      } finally {
        await page.getByTestId('to-gallery').click();
      }
    });
  assert.deepEqual(page.faults, []);
});
