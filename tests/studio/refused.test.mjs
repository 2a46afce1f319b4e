// What the studio's server does not do: for other sites, without the token, outside of its folders.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import http from 'node:http';
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

test('what is too long is refused', async () => {
  assert.equal(await status('POST', 'api/derive', {}, {doc: {text: 'x'.repeat(9_000_000), file: ''}}), 413);
});
