// Every preset that is shipped opens from the gallery, draws, plays, follows a slider and is varied. How long that takes is
// told and not judged, as it is the machine's.
//   node presets.test.mjs FROND PACKAGES [NAME...]
import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {browse, shown, start, visit} from './studio.mjs';

const PLAYED = 2000, DRAGGED = 2000, STEP = 100, VARIED = 20_000; // ms
const [, , , , ...only] = process.argv;
let page, names;
before(async () => {
  const studio = await start();
  page = await visit(await browse(), studio.address, {viewport: {width: 900, height: 600}});
  const cards = page.locator('[data-testid^="card:"]');
  await cards.first().waitFor();
  names = await cards.evaluateAll(list => list.map(card => card.dataset.testid.slice('card:'.length)));
  await page.evaluate(() => {
    const {view} = window.frond, show = view.show.bind(view);
    window.pictures = []; // when each was there
    view.show = answer => {
      const header = show(answer);
      window.pictures.push(performance.now());
      return header;
    };
  });
});

const seconds = ms => `${(ms / 1000).toFixed(1)} s`;

/** What is done is done and shown; answers how long it took. */
async function timed(what) {
  const began = performance.now();
  await what();
  await shown(page);
  return performance.now() - began;
}

/** Pictures that come while something is done, and the longest time that none came. */
async function pictures(what) {
  const began = await page.evaluate(() => ((window.pictures.length = 0), performance.now()));
  await what();
  const [at, ended] = await page.evaluate(() => [window.pictures, performance.now()]);
  const ends = [began, ...at, ended];
  return {count: at.length, longest: Math.max(...ends.slice(1).map((end, i) => end - ends[i]))};
}

async function play() {
  const button = page.getByTestId('play');
  if (!(await button.isEnabled())) return 'a still';
  const {count} = await pictures(async () => {
    await button.click();
    await page.waitForTimeout(PLAYED);
    await button.click();
  });
  await shown(page);
  return `${((1000 * count) / PLAYED).toFixed(1)} pictures a second`;
}

/** Drags the first slider of the first organism to and fro that shapes it. */
async function drag() {
  await page.getByTestId('organism:0').click();
  const sliders = page.locator('[data-testid^="row:organism/"] input[type=range]:visible');
  const shaping = page.locator('[data-testid^="row:organism/"]:not([data-testid$="/count"]) input[type=range]:visible');
  const slider = ((await shaping.count()) > 0 ? shaping : sliders).first();
  if ((await slider.count()) === 0) return 'no slider';
  const name = await slider.evaluate(e => e.closest('[data-testid^="row:"]').dataset.testid.slice('row:organism/'.length));
  const {count, longest} = await pictures(async () => {
    for (let i = 0; i < DRAGGED / STEP; ++i) {
      await slider.press(i % 6 < 3 ? 'ArrowRight' : 'ArrowLeft');
      await page.waitForTimeout(STEP);
    }
  });
  return `${name}: ${count} pictures in ${seconds(DRAGGED)}, longest wait ${seconds(longest)}, whole after ${seconds(await timed(() => {}))}`;
}

/** The wall of variations, for a while: how many are drawn, and a note of why one is not. */
async function vary() {
  await page.getByTestId('variations').click();
  const began = performance.now();
  const drawn = () => page.locator('[data-testid^="variation:"].drawn').evaluateAll(list => list.map(tile => tile.dataset.note ?? ''));
  while ((await drawn()).length < 9 && performance.now() - began < VARIED) await page.waitForTimeout(STEP);
  const notes = await drawn();
  await page.keyboard.press('Escape');
  return `${notes.length} of nine after ${seconds(performance.now() - began)} ${notes.find(Boolean) ?? ''}`;
}

async function leave() {
  await page.getByTestId('to-gallery').click();
  const answer = page.getByTestId('answer:leave');
  if (await answer.isVisible()) await answer.click();
}

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
    await view.settled();
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
  assert.deepEqual(only.filter(name => !names.includes(name)), []);
  for (const name of only.length > 0 ? only : names)
    await t.test(name, async () => {
      try {
        const opened = await timed(() => page.getByTestId(`card:${name}`).click());
        const {nodes, parts, white, colors} = await seen();
        console.log(`${name}: ${nodes} nodes, ${parts} parts, ${white} pixels of the mask, ${colors} colours, after ${seconds(opened)}`);
        assert.ok(parts > 0 && white > 0 && colors > 100);
        for (const what of [play, drag, vary]) console.log(`  ${what.name}: ${await what()}`);
      } finally {
        await leave();
      }
    });
  assert.deepEqual(page.faults, []);
});
