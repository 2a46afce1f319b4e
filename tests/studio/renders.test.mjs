// Every moment of a shipped film can be rendered from the studio: the first, one in the middle and the last. Without FROND_ALL
// a few presets stand for the others: what grows, what is a film of one light, what is sown, what swims, what is a still.
import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {ask, preset, scratch, start} from './studio.mjs';

const FEW = ['asking/light', 'lsystems/sunflower-4', 'reef', 'reef/chromis', 'shells', 'trees/light_race', 'trees/seasons', 'tufted'];
const SIZE = [32, 18];
let studio, presets;
before(async () => {
  studio = await start('--assets', scratch);
  presets = (await ask(studio, 'GET', 'api/start')).json.presets;
});

/** Renders a moment; answers how it ended and what was said. */
async function render(doc, time, size = SIZE) {
  const {status, json} = await ask(studio, 'POST', 'api/render', {doc, time, size, quality: 'draft'});
  assert.equal(status, 200, JSON.stringify(json));
  for (;;) {
    const state = (await ask(studio, 'GET', `api/render/${json.id}`)).json;
    if (!['growing', 'rendering'].includes(state.state)) return {...state, id: json.id};
    await new Promise(done => setTimeout(done, 100));
  }
}

async function rendered(doc, time) {
  const {state, message, id} = await render(doc, time);
  assert.equal(state, 'done', `at ${time} s: ${message}`);
  const {status, body} = await ask(studio, 'GET', `api/render/${id}/picture`);
  assert.equal(status, 200);
  assert.equal(body.subarray(1, 4).toString(), 'PNG');
  return body;
}

const film = text => {
  const frames = Number(/"frames": *(\d+)/.exec(text)?.[1] ?? 72);
  const fps = Number(/"fps": *([\d.]+)/.exec(text)?.[1] ?? 24);
  return frames === 1 ? [0] : [0, Math.floor(frames / 2) / fps, (frames - 1) / fps];
};

test('each moment of the shipped presets is rendered', async t => {
  const names = presets.map(p => p.name);
  for (const name of FEW) assert.ok(names.includes(name), `there is no ${name}`);
  for (const {file, name} of presets) {
    if (!process.env.FROND_ALL && !FEW.includes(name)) continue;
    await t.test(name, async () => {
      const doc = (await ask(studio, 'GET', `api/preset?file=${encodeURIComponent(file)}`)).json;
      for (const time of film(doc.text)) await rendered({text: doc.text, file}, time);
    });
  }
});

test('motion is blurred as in the film', async () => {
  const text = `{"film": {"frames": 6, "fps": 6}, "scene": {"setting": "studio", "camera": {"location": [[0, [0, 0.5, 2]], [1, [2, 0.5, 1]]], "look_at": [0, 0.3, 0],
    "shutter": SHUTTER, "shutter_samples": 4}}, "organisms": [{"kind": "coral", "steps": 2, "height": 0.5}]}`;
  const file = preset('blur.json', text.replace('SHUTTER', '0'));
  const [sharp, blurred] = [await rendered({text: text.replace('SHUTTER', '0'), file}, 0.5), await rendered({text: text.replace('SHUTTER', '1'), file}, 0.5)];
  assert.notDeepEqual(sharp, blurred);
});

test('a render keeps the text that it was made from', async () => {
  const text = '{"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": []} // mine';
  const file = preset('kept.json', text);
  const {state, id, message} = await render({text, file}, 0, [16, 16]);
  assert.equal(state, 'done', message);
  assert.equal((await ask(studio, 'GET', `api/render/${id}/doc`)).json.text, text);
});

test('what is traced shows over the small picture, in the size of the whole', async () => {
  const {file} = presets.find(p => p.name === 'trees/seasons');
  const doc = {text: (await ask(studio, 'GET', `api/preset?file=${encodeURIComponent(file)}`)).json.text, file};
  const {json: {id}} = await ask(studio, 'POST', 'api/render', {doc, time: 0, size: [1280, 720], quality: 'best'});
  const widths = new Set();
  for (let state = {state: 'growing'}; !widths.has(1280);) {
    state = (await ask(studio, 'GET', `api/render/${id}`)).json;
    assert.ok(['growing', 'rendering'].includes(state.state), `${state.state} ${state.message}: it was to take longer`);
    const {status, body} = await ask(studio, 'GET', `api/render/${id}/picture`);
    if (status === 200) widths.add(body.readUInt32BE(16));
    await new Promise(done => setTimeout(done, 200));
  }
  assert.deepEqual([...widths], [320, 1280]);
  await ask(studio, 'DELETE', `api/render/${id}`);
});
