// What is many nodes is asked about before it is grown, however quickly it would grow.
import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {ask, preset, start} from './studio.mjs';

const TEXT = '{"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [{"kind": "plant", "smoothing": 1, "grammar": {"axiom": "A", "steps": 8, "rules": ["A -> F[+A][-A]"]}}]}';
let file, studio;
before(async () => {
  file = preset('own.json', TEXT);
  studio = await start(file);
});

let seq = 0;
const scene = question => ask(studio, 'POST', `api/scene?session=s&seq=${++seq}`, {doc: {text: TEXT, file}, time: 0, have: [], solo: null, hide: [], ...question});

test('many nodes are asked about, and grown where one agrees', async () => {
  const asked = await scene({ask: 1e6, most: 100});
  assert.equal(asked.status, 202);
  assert.ok(asked.json.estimate.nodes > 100, JSON.stringify(asked.json));
  assert.equal((await scene({ask: 1e6, most: 1.5 * asked.json.estimate.nodes})).status, 200);
  // What has grown is not asked about again.
  assert.equal((await scene({ask: 1e6, most: 100})).status, 200);
});

test('nothing is asked of those who do not want it', async () => assert.equal((await scene({ask: null, most: 1})).status, 200));
