// An hour of a person's work, replayed: a bonsai pruned and bent, a word drawn in ivy, a path and a bed, a way of the
// camera, and a film of it. Where FROND_PICTURES names a folder, what is seen on the way is kept there for the docs.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {before, test} from 'node:test';
import {ask, browse, drag, pixelOf, preset, scratch, shown, start, visit} from './studio.mjs';

const pictures = process.env.FROND_PICTURES;
let browser;
before(async () => (browser = await browse()));

const bonsai = fs.readFileSync('presets/trees/bonsai.json', 'utf8');
/** The tree as it grew, before hands were laid on it; a test does not need its needles. */
const GROWN = bonsai.replace(/\n *"edits": \[[^\]]*(?:\[[^\]]*\][^\]]*)*\],/, '').replace('"$schema": "../../', '"$schema": "');

const GARDEN = `// A corner of a garden.
{
  "title": "An evening in the garden",
  "film": {"frames": 12, "fps": 6, "size": [160, 90]},
  "scene": {
    "setting": "garden",
    "camera": {"location": [0, 3.2, 8.5], "look_at": [0, 0.6, 0.6], "angle": 50},
    "meadow": {"blade": 0}, "floor": {"relief": 0}, "garden": {"pond": {"size": [0, 0]}}
  },
  "organisms": [
    {"kind": "wall", "name": "wall", "width": 4.4, "height": 1.9, "thickness": 0.3, "ruin": 0, "place": {"at": [[0, -1]], "turn_variation": 0, "lean": 0, "size_variation": 0}},
    {"kind": "ivy", "name": "ivy", "on": ["wall"], "count": 10, "crawl": {"speed": 0.03, "max_age": 60, "branch_every": 0.15, "branch_angle": 50, "spacing": 0.06, "bias": 0, "let_go": 0}, "leaves": {"size": 0.06, "bare": 0}},
    {"kind": "plant", "name": "daisies", "height": 0.2, "count": 60, "sown": {"models": 2, "where": {"layer": "herbs", "radius": 0.08}},
     "grammar": {"axiom": "F[+F][-F]F"}}
  ]
}
`;

/** One person at work on a preset. */
async function work(name, text) {
  const studio = await start(preset(name, text));
  const page = await visit(browser, studio.address, {viewport: {width: 1280, height: 800}});
  await shown(page);
  let number = 0;
  const began = Date.now();
  const json = async () => {
    await page.evaluate(() => dispatchEvent(new Event('pagehide')));
    const draft = await page.evaluate(() => JSON.parse(sessionStorage.getItem('frond.draft')));
    return JSON.parse(draft.text.replace(/(^|\s)\/\/.*$/gm, ''));
  };
  return {
    studio,
    page,
    json,
    /** One act: done, shown, timed, and kept as a picture. */
    async act(what, does) {
      const from = Date.now();
      await does();
      await shown(page);
      console.log(`  ${name.replace('.json', '')}: ${what}: ${((Date.now() - from) / 1000).toFixed(1)} s`);
      if (!pictures) return;
      await page.evaluate(() => window.frond.settled());
      await page.screenshot({path: path.join(pictures, `${name.replace('.json', '')}-${++number}.png`)});
    },
    over: async (...places) => drag(page, ...(await Promise.all(places.map(at => pixelOf(page, at))))),
    async leave() {
      console.log(`  ${name.replace('.json', '')}: ${((Date.now() - began) / 1000).toFixed(0)} s`);
      assert.deepEqual(page.faults, []);
      await page.getByTestId('save').click();
      await page.getByText(/^Saved /).waitFor();
      await page.context().close();
      await studio.stop();
    },
  };
}

test('a bonsai is pruned and bent', async () => {
  const {page, act, json, leave} = await work('bonsai.json', GROWN);
  const tree = JSON.parse(GROWN.replace(/(^|\s)\/\/.*$/gm, '')).organisms.findIndex(o => o.kind === 'tree');
  await page.getByTestId(`organism:${tree}`).click();
  await page.getByTestId('tool:branches').click();
  const find = async at => {
    await page.getByTestId('branch-address').fill(at);
    await page.getByTestId('branch:find').click();
    await page.getByTestId('branch').getByText(`branch ${at}`).waitFor();
  };
  await act('a limb is found', () => find('12:0.3'));
  await act('it is sawn off', () => page.getByTestId('branch:cut').click());
  await act('another one', async () => {
    await find('15:0.4');
    await page.getByTestId('branch:cut').click();
  });
  await act('a limb is wired down', async () => {
    await find('20:0.6');
    const from = await page.evaluate(() => window.frond.view.tool.drawn.children.find(one => one.geometry.type === 'SphereGeometry').position.toArray());
    await drag(page, await pixelOf(page, from), await pixelOf(page, [from[0], from[1] - 0.12, from[2]]));
  });
  const {edits} = (await json()).organisms[tree];
  assert.deepEqual(edits.slice(0, 2), [{at: '12:0.3', cut: true}, {at: '15:0.4', cut: true}]);
  assert.equal(edits[2].at, '20:0.6');
  assert.ok(edits[2].bend[1] < -0.05, JSON.stringify(edits[2]));
  await leave();
});

test('a word in ivy, a path, a bed that is sown, a way of the camera, and a film', async () => {
  const {studio, page, act, json, over, leave} = await work('evening.json', GARDEN);
  const draw = async what => {
    await page.getByTestId('tool:draw').click();
    await page.getByTestId('draw-what').selectOption(what);
  };
  await page.getByTestId('organism:1').click();
  await act('three letters are drawn on the wall', async () => {
    await draw('strand');
    const z = -0.83;
    // I, V, Y
    for (const stroke of [[[-1.5, 0.4], [-1.5, 1.5]], [[-0.5, 1.5], [-0.1, 0.4], [0.3, 1.5]], [[1, 1.5], [1.35, 0.95], [1.35, 0.4]], [[1.7, 1.5], [1.35, 0.95]]]) {
      await over(...stroke.map(([x, y]) => [x, y, z]));
      await shown(page);
    }
  });
  await act('a path is drawn', async () => {
    await draw('path');
    await over([-2, 0, 3], [0, 0, 2.2], [2.2, 0, 2.6]);
  });
  await act('a bed is drawn below the wall', async () => {
    await draw('bed');
    await over([-2, 0, -0.6], [2, 0, -0.6], [1.6, 0, 0.4], [-1.6, 0, 0.4]);
  });
  await act('daisies are sown in it', async () => {
    await page.getByTestId('organism:2').click();
    await page.getByTestId('tool:paint').click();
    await page.getByTestId('paint:none').click();
    await shown(page);
    await over([-1.5, 0, -0.1], [1.5, 0, -0.1]);
  });
  await act('the camera walks along', async () => {
    await draw('way');
    await over([-2, 0, 4.4], [1.5, 0, 4.6]);
  });
  await act('the film is rendered', async () => {
    await page.getByTestId('tab:film').click();
    await page.getByTestId('film-rough').uncheck();
    await page.getByTestId('film-start').click();
    await page.getByTestId('film:evening-1').waitFor();
    for (let film; (film = (await ask(studio, 'GET', 'api/film/evening-1')).json).state !== 'done';) {
      assert.notEqual(film.state, 'failed', film.message);
      await new Promise(done => setTimeout(done, 300));
    }
  });
  const said = await json();
  assert.equal(said.organisms[1].crawl.guides.length, 4);
  assert.ok(said.scene.garden.path.points.length > 2 && said.scene.garden.areas[0].outline.length > 3);
  assert.ok(said.scene.camera.location.length >= 2);
  assert.ok(fs.existsSync(path.join(scratch, said.organisms[2].sown.where.map)));
  await leave();
});
