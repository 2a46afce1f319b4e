// What the studio's server does not do: for other sites, without the token, outside of its folders.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import http from 'node:http';
import net from 'node:net';
import path from 'node:path';
import {before, test} from 'node:test';
import {preset, scratch, start} from './studio.mjs';

const TEXT = '{"scene": {"setting": "studio"}, "organisms": []}';
let studio;
before(async () => (studio = await start(preset('own.json', TEXT))));

/** The status that a request is answered with. */
function status(method, where, headers = {}, body) {
  const all = {'X-Frond-Token': studio.token, 'Content-Type': 'application/json', ...headers};
  return new Promise((resolve, reject) => {
    const request = http.request(studio.base + where, {method, headers: all}, answer => {
      answer.resume();
      answer.on('end', () => resolve(answer.statusCode));
    });
    request.on('error', reject);
    request.end(body && JSON.stringify(body));
  });
}
/** What comes for that, to the end of the connection. */
function raw(text) {
  return new Promise((resolve, reject) => {
    const socket = net.connect(studio.port, '127.0.0.1', () => socket.write(text));
    let heard = '';
    socket.on('data', data => (heard += data));
    socket.on('end', () => resolve(heard));
    socket.on('error', reject);
  });
}
const save = file => status('POST', 'api/save', {}, {doc: {text: TEXT, file: path.join(scratch, 'own.json')}, file, disk: null, overwrite: true});

test('its own page is answered', async () => assert.equal(await status('GET', 'api/ping'), 200));

test('nobody is answered without the token, or with another', async () => {
  assert.equal(await status('GET', 'api/start', {'X-Frond-Token': ''}), 403);
  assert.equal(await status('GET', 'api/start', {'X-Frond-Token': '0'.repeat(studio.token.length)}), 403);
  assert.equal(await status('POST', 'api/scene', {'X-Frond-Token': 'x'}, {}), 403);
});

test('other sites are refused', async () => {
  for (const headers of [{Origin: 'http://example.org'}, {Origin: 'null'}, {Host: 'example.org'}, {Host: `example.org:${studio.port}`}])
    assert.ok([403, 421].includes(await status('GET', 'api/ping', headers)), JSON.stringify(headers));
});

test('nothing is written or read outside of the preset\'s folder', async () => {
  fs.mkdirSync(path.join(scratch, 'inside'));
  const outside = path.join(path.dirname(scratch), `${path.basename(scratch)}_outside.json`);
  fs.symlinkSync(path.dirname(scratch), path.join(scratch, 'inside', 'link'));
  for (const file of [outside, `../${path.basename(outside)}`, path.join(scratch, '..', path.basename(outside)), path.join(scratch, 'inside', 'link', path.basename(outside))]) {
    assert.equal(await save(file), 403, file);
    assert.equal(fs.existsSync(outside), false, file);
  }
  assert.equal(await status('GET', `api/preset?file=${encodeURIComponent('/etc/passwd')}`), 403);
  assert.equal(await status('GET', 'api/gallery/..%2f..%2fREADME.md'), 404);
  assert.equal(await save(path.join(scratch, 'own.json')), 200);
});

test('what does not say how long it is, or is packed, is not read', async () => {
  assert.equal(await status('POST', 'api/mesh?name=a.obj', {'Transfer-Encoding': 'chunked'}, {}), 411);
  assert.equal(await status('POST', 'api/mesh?name=a.obj', {'Content-Encoding': 'gzip', 'Content-Length': '2'}, {}), 415);
  const answer = await raw(`POST /api/mesh?name=a.obj HTTP/1.1\r\nHost: 127.0.0.1:${studio.port}\r\nX-Frond-Token: ${studio.token}\r\n\r\nv 0 0 0`);
  assert.match(answer, /^HTTP\/1.1 411 /);
  assert.equal(fs.existsSync(path.join(scratch, 'a.obj')), false);
  assert.equal(await status('PUT', 'api/save', {}, {}), 405);
  assert.equal(await status('POST', '', {'X-Frond-Token': ''}, {}), 405);
});

test('those who ask slowly, without the token, do not keep others out', async () => {
  const slow = Array.from({length: 120}, () => net.connect(studio.port, '127.0.0.1'));
  try {
    for (const socket of slow) socket.on('error', () => undefined).write('GET /api/start HTTP/1.1\r\nHost: ');
    assert.equal(await status('GET', 'api/ping'), 200);
    assert.equal(await status('GET', '', {'X-Frond-Token': ''}), 200);
  } finally {
    slow.forEach(socket => socket.destroy());
  }
});

test('the token stands in no program\'s arguments', async () => {
  const folder = path.join(scratch, 'desktop');
  const noted = path.join(folder, 'noted');
  fs.mkdirSync(folder);
  fs.writeFileSync(path.join(folder, 'xdg-open'), `#!/bin/sh\n{ echo "$*"; stat -c %a "$1" "$(dirname "$1")"; cat "$1"; } > '${noted}.part'; mv '${noted}.part' '${noted}'\n`, {mode: 0o755});
  const before = process.env.PATH;
  process.env.PATH = `${folder}:${before}`;
  const opened = await start(path.join(scratch, 'own.json'), '--open').finally(() => (process.env.PATH = before));
  while (!fs.existsSync(noted)) await new Promise(done => setTimeout(done, 20));
  const [file, ofFile, ofFolder, ...text] = fs.readFileSync(noted, 'utf8').split('\n');
  assert.ok(!file.includes(opened.token));
  assert.deepEqual([ofFile, ofFolder], ['600', '700']);
  assert.ok(text.join('\n').includes(opened.address));
  await opened.stop();
  assert.equal(fs.existsSync(file), false);
});

test('what is too long is refused', async () => {
  assert.equal(await status('POST', 'api/mesh?name=a.obj', {'Content-Length': String(80 << 20)}), 413);
  assert.equal(await status('POST', 'api/derive', {}, {doc: {text: 'x'.repeat(9_000_000), file: ''}}), 413);
});

test('no number wraps into another', async () => {
  const doc = {text: '{"scene": {"setting": "studio"}, "organisms": [{"kind": "plant", "grammar": {"axiom": "F", "steps": 1, "rules": ["F -> FF"]}}]}', file: path.join(scratch, 'own.json')};
  const answer = (where, question) => status('POST', where, {}, {doc, ...question});
  for (const size of [[4294967360, 64], [64, 1e300], [64.5, 64], [-64, 64], [64], 'large', [64, null]])
    for (const where of ['api/render', 'api/film']) assert.equal(await answer(where, {size, quality: 'draft'}), 400, `${where} ${size}`);
  for (const steps of [4294967297, 1e300, -1, 1.5]) assert.equal(await answer('api/derive', {entry: 0, steps}), 400, String(steps));
  for (const entry of [-1, 4294967296 * 4294967296, 1e300, 0.5]) assert.notEqual(await answer('api/derive', {entry, steps: 1}), 200, String(entry));
  for (const time of [1e300, -1e300, 'now']) {
    assert.equal(await answer('api/render', {time, size: [64, 64], quality: 'draft'}), 400, String(time));
    assert.equal(await answer('api/trace', {time, rays: []}), 400, String(time));
  }
  assert.equal(await answer('api/trace', {time: 0, rays: [[0, 1e300, 0, 0, -1, 0]]}), 400);
  assert.equal(await answer('api/trace', {time: 0, rays: [[0, 1, 0, 0, -1]]}), 400);
  assert.equal(await answer('api/derive', {entry: 0, steps: 1}), 200);
});

test('a name of a file ends where it ends', async () => {
  assert.equal(await save('.bashrc\0.json'), 403);
  assert.equal(fs.existsSync(path.join(scratch, '.bashrc')), false);
});

test('unfinished questions do not keep others out', async () => {
  const slow = Array.from({length: 200}, () => net.connect(studio.port, '127.0.0.1'));
  try {
    for (const socket of slow)
      socket.on('error', () => undefined).write(`POST /api/derive HTTP/1.1\r\nHost: 127.0.0.1:${studio.port}\r\nX-Frond-Token: ${studio.token}\r\nContent-Length: 1000\r\n\r\n{`);
    await new Promise(done => setTimeout(done, 500));
    const began = Date.now();
    assert.equal(await status('GET', 'api/ping'), 200);
    assert.ok(Date.now() - began < 2000, `${Date.now() - began} ms`);
  } finally {
    slow.forEach(socket => socket.destroy());
  }
});
