// A server that gets no more memory says so, and goes on.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import {before, test} from 'node:test';
import {ask, preset, start} from './studio.mjs';

const SMALL = '{"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [{"kind": "plant", "grammar": {"axiom": "F", "steps": 1, "rules": ["F -> FF"]}}]}';
// Some 1.5 million nodes.
const LARGE = '{"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [{"kind": "plant", "grammar": {"axiom": "A", "steps": 20, "rules": ["A -> F[+A][-A]"]}}]}';
const MORE = 200; // MB
let studio, file;
before(async () => {
  file = preset('own.json', SMALL);
  studio = await start(file);
});

/** How much address space the server may have; 0: any. */
const allow = megabytes => {
  const taken = Number(/VmSize:\s+(\d+) kB/.exec(fs.readFileSync(`/proc/${studio.process.pid}/status`, 'utf8'))[1]);
  execFileSync('prlimit', ['--pid', String(studio.process.pid), `--as=${megabytes ? taken * 1024 + megabytes * 2 ** 20 : 'unlimited'}:`]);
};

/** Asks until there is an answer: where memory has run out there may be none for an answer either, and the server hangs up. */
async function answered(...question) {
  for (let tries = 0; tries < 100; ++tries) {
    const answer = await ask(studio, ...question).catch(() => null);
    if (answer) return answer;
    await new Promise(done => setTimeout(done, 100));
  }
  throw new Error(`no answer to ${question[1]}`);
}

async function render(text) {
  const {status, json} = await answered('POST', 'api/render', {doc: {text, file}, time: 0, size: [32, 18], quality: 'draft'});
  assert.equal(status, 200, JSON.stringify(json));
  for (;;) {
    const {status, json: state} = await answered('GET', `api/render/${json.id}`);
    if (status === 200 && !['growing', 'rendering'].includes(state.state)) return state;
    await new Promise(done => setTimeout(done, 100));
  }
}

test('a render and a view for which there is no memory are told, and the server goes on', async () => {
  const view = text => answered('POST', 'api/scene?session=s&seq=0', {doc: {text, file}, time: 0, have: [], solo: null, hide: [], ask: null});
  assert.equal((await render(SMALL)).state, 'done');
  allow(MORE);
  const {state, message} = await render(LARGE);
  assert.equal(state, 'failed');
  assert.match(message, /memory/);
  const {status, json} = await view(LARGE);
  assert.ok([422, 500].includes(status), String(status));
  assert.match(JSON.stringify(json), /memory/);
  allow(0);
  assert.equal((await ask(studio, 'GET', 'api/ping')).status, 200);
  assert.equal((await render(SMALL)).state, 'done');
});
