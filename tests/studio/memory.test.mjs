// However long somebody works, the server keeps no more than it may, and gives back what it gives up.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import {before, test} from 'node:test';
import {ask, start} from './studio.mjs';

const ROOM = 32; // MB
const SLACK = 96; // MB that its work and the allocator may take besides
let studio;
before(async () => (studio = await start('presets/species/corals/brain.json', '--memory', String(ROOM))));

const resident = () => Number(/VmRSS:\s+(\d+) kB/.exec(fs.readFileSync(`/proc/${studio.process.pid}/status`, 'utf8'))[1]) / 1024;

test('other seeds, again and again, fill no more than the room there is', async () => {
  const {text, file} = (await ask(studio, 'GET', 'api/start')).json.preset;
  let seq = 0;
  const scene = async (doc, time) => {
    const {status, json} = await ask(studio, 'POST', `api/scene?session=s&seq=${++seq}`, {doc: {text: doc, file}, time, have: [], solo: null, hide: [], ask: null});
    assert.equal(status, 200, JSON.stringify(json));
  };
  await scene(text, 0);
  const first = resident();
  for (let step = 0; step < 25; ++step) {
    await scene(text.replace(/"seed": \d+/, `"seed": ${step}`), 0);
    const {kept, room} = (await ask(studio, 'GET', 'api/ping')).json;
    assert.equal(room, ROOM << 20);
    assert.ok(kept <= room, `${kept} bytes are kept`);
  }
  const last = resident();
  console.log(`${first.toFixed()} MB, then ${last.toFixed()} MB`);
  assert.ok(last < first + ROOM + SLACK, `${first} MB became ${last} MB`);
});
