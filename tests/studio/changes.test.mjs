// What is changed is shown first, alone; then all else.
import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {browse, preset, shown, start, visit, visitIn} from './studio.mjs';

const TEXT = `{
  "film": {"frames": 1, "size": [320, 240]},
  "scene": {"setting": "underwater", "floor": {"stones": 0}, "camera": {"location": [0, 1.2, 3], "look_at": [0, 0.3, 0], "angle": 50}},
  "organisms": [
    {"kind": "rock", "name": "stone", "size": 0.6, "depth": 5, "place": {"at": [[0, 0]]}},
    {"kind": "coral", "name": "coral", "steps": 3, "height": 0.3, "place": {"at": [[0, 0]], "on": ["stone"]}}
  ]
}`;

let page;
before(async () => {
  const studio = await start(preset('changes.json', TEXT));
  page = await visit(await browse(), studio.address);
  await shown(page);
  // Each picture: who is missing in the answer, and of whom something is drawn.
  await page.evaluate(() => {
    const {view} = window.frond, show = view.show.bind(view);
    window.pictures = [];
    view.show = answer => {
      const header = show(answer);
      window.pictures.push({missing: header.missing, drawn: [...new Set(view.shown.map(({part}) => part.entry))].sort(), specimens: header.specimens.length});
      return header;
    };
  });
});

test('an organism that is changed does not wait for what stands on it', async () => {
  await page.getByTestId('organism:0').click();
  const slider = page.locator('[data-testid="row:organism/size"] input[type=range]');
  await slider.press('ArrowRight');
  await page.waitForFunction(() => window.pictures.some(picture => picture.missing.length > 0));
  await shown(page);
  const pictures = await page.evaluate(() => window.pictures);
  assert.deepEqual(pictures[0], {missing: [1], drawn: [-1, 0, 1], specimens: 2}, 'the coral is seen as it was');
  assert.deepEqual(pictures.at(-1), {missing: [], drawn: [-1, 0, 1], specimens: 2});
});

test('what stands by itself is shown at once, as it is', async () => {
  await page.getByTestId('organism:1').click();
  await page.evaluate(() => (window.pictures = []));
  await page.locator('[data-testid="row:organism/height"] input[type=range]').press('ArrowRight');
  await page.waitForFunction(() => window.pictures.length > 0);
  await shown(page);
  // Where it takes longer than a fifth of a second it is drawn roughly first: two pictures then, neither with a gap.
  for (const picture of await page.evaluate(() => window.pictures)) assert.deepEqual(picture, {missing: [], drawn: [-1, 0, 1], specimens: 2});
  assert.deepEqual(page.faults, []);
});

test('growing is stopped, and goes on when it is told to', async () => {
  const rocks = Array.from({length: 16}, (_, i) => `{"kind": "rock", "size": 0.5, "depth": 8, "place": {"at": [[${i - 8}, 0]], "rock": 0}}`);
  const studio = await start(preset('rocks.json', `{"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [${rocks}]}`));
  const other = await visitIn(page.context(), studio.address);
  // From within the page: on a slow machine all has grown before a click from without comes through.
  await other.evaluate(() => new Promise(done => {
    const look = setInterval(() => {
      if (document.querySelector('[data-testid=growing]')?.hidden !== false) return;
      clearInterval(look);
      document.querySelector('[data-testid=stop-growing]').click();
      done();
    }, 10);
  }));
  await other.getByTestId('grow-on').waitFor();
  const grown = () => other.evaluate(() => window.frond.view.header?.missing.length === 0);
  assert.equal(await grown(), false);
  await other.getByTestId('grow-on').click();
  await shown(other);
  assert.equal(await grown(), true);
  await studio.stop();
});
