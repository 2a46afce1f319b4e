// A film from the studio: rendered, paused, gone on with by another studio, played, and its storyboard; all by mouse and keyboard.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {before, test} from 'node:test';
import {ask, browse, choose, preset, scratch, shown, start, visit} from './studio.mjs';

const TEXT = `{
  // mine
  "title": "a coral", "film": {"frames": 24, "fps": 12, "size": [160, 90]},
  "scene": {"setting": "studio", "camera": {"location": [[0, [0, 0.6, 2.4]], [2, [1, 0.6, 2]]], "look_at": [0, 0.3, 0]}},
  "organisms": [{"kind": "coral", "steps": 3, "height": 0.6, "growth": {"duration": 1.5}}]
}`;
const file = preset('coral.json', TEXT);
let browser, studio, page;
before(async () => {
  browser = await browse();
  studio = await start(file);
  page = await visit(browser, studio.address, {viewport: {width: 1100, height: 760}});
  await shown(page);
  await page.getByTestId('tab:film').click();
});

const state = id => ask(studio, 'GET', `api/film/${id}`).then(({json}) => json);

async function until(id, ...states) {
  for (;;) {
    const now = await state(id);
    if (states.includes(now.state)) return now;
    assert.notEqual(now.state, 'failed', now.message);
    await new Promise(done => setTimeout(done, 100));
  }
}

test('the storyboard shows moments of the film, and a click goes there', async () => {
  const moments = page.locator('[data-testid="storyboard"] button');
  assert.equal(await moments.count(), 12);
  await page.waitForFunction(() => [...document.querySelectorAll('[data-testid="storyboard"] img')].every(img => img.naturalWidth === 160));
  await page.getByTestId('moment:0').click();
  assert.equal(await page.getByTestId('time').inputValue(), '0');
  // By the keyboard, too.
  await page.getByTestId('moment:11').focus();
  await page.keyboard.press('Enter');
  assert.ok(Math.abs(Number(await page.getByTestId('time').inputValue()) - 23 / 12) < 1e-6);
});

test('a film is rendered, paused, gone on with and played', async () => {
  await page.getByTestId('film-start').click();
  await page.getByTestId('film:coral-1').waitFor();
  const folder = path.join(scratch, 'out/films/coral-1');
  assert.equal((await state('coral-1')).folder, fs.realpathSync(folder));
  // The rough film plays while the whole one is made.
  await page.waitForFunction(() => document.querySelector('[data-testid="film-video"]').src.includes('rough.mp4'));
  while ((await state('coral-1')).done < 3) await new Promise(done => setTimeout(done, 50));
  await page.locator('[data-testid="storyboard"] button.rendered').first().waitFor();
  await page.getByTestId('pause-film:coral-1').click();
  const paused = await until('coral-1', 'paused');
  assert.ok(paused.done >= 3 && paused.done < 24, `${paused.done} frames`);

  // Another studio goes on with it, with the text as it was.
  const kept = fs.readdirSync(path.join(folder, 'frames')).filter(name => name.endsWith('.png'))[0];
  const when = fs.statSync(path.join(folder, 'frames', kept)).mtimeMs;
  await studio.stop();
  studio = await start(file);
  await page.close();
  page = await visit(browser, studio.address, {viewport: {width: 1100, height: 760}});
  await shown(page);
  await page.getByTestId('tab:film').click();
  await page.getByTestId('resume-film:coral-1').focus();
  await page.keyboard.press('Enter');
  assert.equal((await until('coral-1', 'done')).done, 24);
  assert.equal(fs.statSync(path.join(folder, 'frames', kept)).mtimeMs, when, 'a finished frame was rendered again');

  await page.getByTestId('film:coral-1').click();
  const video = page.getByTestId('film-video');
  // The page asks how far the film is twice a second: it may play the rough one still.
  await page.waitForFunction(() => {
    const {src, readyState} = document.querySelector('[data-testid="film-video"]');
    return src.includes('/film.mp4') && readyState >= 2;
  });
  assert.ok(Math.abs((await video.evaluate(v => v.duration)) - 2) < 0.1);
  await video.evaluate(v => new Promise(done => {
    v.pause();
    v.addEventListener('seeked', done, {once: true});
    v.currentTime = 1.5;
  }));
  assert.ok(Math.abs((await video.evaluate(v => v.currentTime)) - 1.5) < 0.1);
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByTestId('save-film:coral-1').click()]);
  assert.equal(saved.suggestedFilename(), 'coral-1.mp4');
  assert.deepEqual(fs.readFileSync(await saved.path()), fs.readFileSync(path.join(folder, 'film.mp4')));
});

/** The preset as its text says. */
async function now() {
  await page.getByTestId('tab:text').click();
  const text = await page.evaluate(() => document.querySelector('[data-testid="text"]').value);
  await page.getByTestId('tab:film').click();
  return {text, ...JSON.parse(text.replace(/\/\/.*/, ''))};
}
const eye = () => page.evaluate(() => window.frond.view.eye());
const near = (a, b) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) < 2e-3, `${a} is not ${b}`));

test('a view is kept, named, gone back to and removed', async () => {
  await choose(page, 'views', 'view:front');
  const front = await eye();
  await page.getByTestId('add-view').click();
  await page.getByTestId('view-name:0').fill('from the front');
  await page.keyboard.press('Tab');
  const {text, scene} = await now();
  assert.equal(scene.views[0].name, 'from the front');
  near(scene.views[0].at, front.at);
  assert.ok(text.includes('// mine'));
  await choose(page, 'views', 'view:top');
  assert.notDeepEqual((await eye()).at, front.at);
  await page.getByTestId('go-view:0').focus();
  await page.keyboard.press('Enter');
  near((await eye()).at, front.at);
  near((await eye()).to, front.to);
  await page.getByTestId('remove-view:0').click();
  assert.deepEqual((await now()).scene.views ?? [], []);
  for (let i = 0; i < 3; ++i) await page.getByTestId('undo').click();
  assert.equal((await now()).text, TEXT);
});

test('the camera gets a key from what is looked at, at the time shown', async () => {
  await page.getByTestId('moment:6').click();
  await shown(page);
  const time = Number(await page.getByTestId('time').inputValue());
  await choose(page, 'views', 'view:side');
  const side = await eye();
  await page.getByTestId('key-view').focus();
  await page.keyboard.press('Enter');
  const {camera} = (await now()).scene;
  assert.deepEqual(camera.location.map(([t]) => t), [0, Number(time.toFixed(3)), 2]);
  near(camera.location[1][1], side.at);
  // What stood still has a key where it was, and one here.
  assert.deepEqual(camera.look_at[0], [0, [0, 0.3, 0]]);
  near(camera.look_at[1][1], side.to);
  await page.getByTestId('undo').click();
  assert.equal((await now()).text, TEXT);
});

test('a part of a film is asked for, and what is removed is gone', async () => {
  await page.getByTestId('film-first').fill('5');
  await page.getByTestId('film-last').fill('8');
  await page.getByTestId('film-rough').uncheck();
  await page.getByTestId('film-start').click();
  const done = await until('coral-2', 'done');
  assert.deepEqual(done.there, [5, 6, 7, 8]);
  const folder = path.join(scratch, 'out/films/coral-2');
  assert.ok(fs.existsSync(folder) && !fs.existsSync(path.join(folder, 'rough')));
  await page.getByTestId('remove-film:coral-2').click();
  await page.getByTestId('answer:remove').click();
  await page.getByTestId('film:coral-2').waitFor({state: 'detached'});
  assert.ok(!fs.existsSync(folder));
  assert.deepEqual(page.faults, []);
});

test('a film with a transparent background plays, and is saved as what it is', async () => {
  await page.getByTestId('tab:text').click();
  const text = page.getByTestId('text');
  await text.fill(TEXT.replace('"frames": 24,', '"frames": 3, "background": "transparent",'));
  await shown(page);
  await page.getByTestId('tab:film').click();
  await page.getByTestId('film-rough').check();
  for (const name of ['film-first', 'film-last']) await page.getByTestId(name).fill('');
  await page.getByTestId('film-start').press('Enter');
  await page.getByTestId('save-film:coral-2').waitFor();
  const {film, plays, folder} = await until('coral-2', 'done');
  assert.deepEqual([film, plays], ['film.mov', 'film.webm']);
  assert.ok(fs.existsSync(path.join(folder, 'rough/film.webm')));
  await page.waitForFunction(() => {
    const video = document.querySelector('[data-testid="film-video"]');
    return video.src.includes('film.webm') && video.readyState >= 2;
  });
  // What is behind it shows through.
  const alpha = await page.getByTestId('film-video').evaluate(video => {
    const canvas = new OffscreenCanvas(video.videoWidth, video.videoHeight).getContext('2d');
    canvas.drawImage(video, 0, 0);
    return canvas.getImageData(1, 1, 1, 1).data[3];
  });
  assert.equal(alpha, 0);
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByTestId('save-film:coral-2').click()]);
  assert.equal(saved.suggestedFilename(), 'coral-2.mov');
  assert.deepEqual(fs.readFileSync(await saved.path()), fs.readFileSync(path.join(folder, 'film.mov')));
  assert.deepEqual(page.faults, []);
});

test('a player may ask for any part of a film', async () => {
  const whole = await fetch(`${studio.base}api/film/coral-1/film.mp4?token=${studio.token}`).then(a => a.arrayBuffer());
  const part = await fetch(`${studio.base}api/film/coral-1/film.mp4?token=${studio.token}`, {headers: {Range: 'bytes=100-299'}});
  assert.equal(part.status, 206);
  assert.deepEqual(Buffer.from(await part.arrayBuffer()), Buffer.from(whole).subarray(100, 300));
  assert.equal((await fetch(`${studio.base}api/film/coral-1/film.json?token=${studio.token}`)).status, 404);
  assert.equal((await fetch(`${studio.base}api/film/..%2Fcoral-1/film.mp4?token=${studio.token}`)).status, 404);
});
