// What the tests of the studio's page share: a server of its own, a browser without a screen, and its page.
//   node NAME.test.mjs FROND PACKAGES
// FROND is the program, PACKAGES a folder with node_modules/. The folder that it runs in is that of the sources.
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';
import {after} from 'node:test';

const [program, packages] = process.argv.slice(2);
export const frond = path.resolve(program);
export const load = createRequire(path.join(path.resolve(packages), 'node_modules/'));

/** Longest that anything may take on a slow machine, in ms. */
export const PATIENCE = +(process.env.FROND_PATIENCE ?? 300_000);

/** A folder that goes when the tests are over. */
export const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'frond_studio_'));
after(() => fs.rmSync(scratch, {recursive: true}));

/** Writes a preset there and answers where. */
export function preset(name, text) {
  const file = path.join(scratch, name);
  fs.writeFileSync(file, text);
  return file;
}

const running = new Set();
const browsers = [];
after(async () => {
  for (const browser of browsers) await browser.close();
  running.forEach(server => server.kill());
});

/** Starts the studio; resolves when it has printed its address. */
export function start(...words) {
  const server = spawn(frond, ['studio', ...words], {env: {...process.env, FROND_HOME: process.cwd()}});
  running.add(server);
  return new Promise((resolve, reject) => {
    let said = '';
    server.on('exit', code => {
      running.delete(server);
      reject(new Error(`the studio ended with ${code}: ${said}`));
    });
    server.stderr.on('data', data => (said += data));
    server.stdout.on('data', data => {
      const found = /(http:\/\/127\.0\.0\.1:(\d+)\/)#token=(\w+)/.exec(data);
      if (found) resolve({address: found[0], base: found[1], port: Number(found[2]), token: found[3], process: server, stop: () => stop(server)});
    });
  });
}

function stop(server) {
  const ended = new Promise(resolve => server.on('exit', resolve));
  server.kill();
  return ended;
}

/** Chromium draws in software, so that it is the same everywhere. */
export async function browse() {
  const browser = await load('playwright-core').chromium.launch({
    executablePath: '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  browsers.push(browser);
  return browser;
}

/** Asks a studio without a browser: the status, the bytes, and what they are as JSON. */
export function ask(studio, method, where, body) {
  const headers = {'X-Frond-Token': studio.token, 'Content-Type': 'application/json'};
  return new Promise((resolve, reject) => {
    const request = http.request(studio.base + where, {method, headers}, answer => {
      const parts = [];
      answer.on('data', part => parts.push(part));
      answer.on('end', () => {
        const bytes = Buffer.concat(parts);
        const isJson = answer.headers['content-type'] === 'application/json';
        resolve({status: answer.statusCode, body: bytes, json: isJson ? JSON.parse(bytes) : null});
      });
    });
    request.on('error', reject);
    request.end(body && JSON.stringify(body));
  });
}

/** Goes to another part of a page, which hears of it (hashchange) a moment after its address is another. */
export async function follow(page, address) {
  await page.goto(address);
  await page.evaluate(() => new Promise(requestAnimationFrame));
}

/** A page of a browser; `faults` collects what it throws. */
export async function visit(browser, address, options = {}) {
  const context = await browser.newContext({viewport: {width: 900, height: 600}, reducedMotion: 'reduce', ...options});
  context.setDefaultTimeout(PATIENCE);
  return visitIn(context, address);
}

/** One more tab of the same browser. */
export async function visitIn(context, address) {
  const page = await context.newPage();
  page.faults = [];
  page.on('pageerror', error => page.faults.push(error.stack));
  page.on('console', message => message.type() === 'error' && page.faults.push(`${message.text()} ${message.location().url}`));
  await page.goto(address);
  return page;
}

/** Waits until the view shows what the text says; where the page asks whether it may take long, it may. */
export async function shown(page) {
  const grow = page.getByTestId('answer:grow');
  await page.waitForFunction(() => window.frond?.view);
  for (;;) {
    const settled = page.evaluate(() => window.frond.shown().then(() => window.frond.view.drawn()).then(() => 'shown'));
    const asked = grow.waitFor().then(() => 'asked', () => 'gone');
    if ((await Promise.race([settled, asked])) === 'asked') {
      await grow.click();
      continue;
    }
    if (await grow.isVisible()) await grow.click();
    else if (await page.evaluate(() => window.frond.view.header !== null)) return;
    else await page.waitForFunction(() => window.frond.view.header !== null || document.querySelector('[data-testid="answer:grow"]'));
  }
}

/** What stands for all that the view shows. */
export const parts = page => page.evaluate(() => window.frond.view.header.parts.map(part => part.id).join());

/** Another picture than that of `parts` before. */
export const changed = (page, before) =>
  page.waitForFunction(before => window.frond.view.header.parts.map(part => part.id).join() !== before, before);

/** Chooses from a menu. */
export async function choose(page, menu, item) {
  await page.getByTestId(menu).click();
  await page.getByTestId(item).click();
}

/** Where a point is in a page's window. */
export const pixelOf = (page, at) =>
  page.evaluate(([x, y, z]) => {
    const {view} = window.frond;
    const {x: left, y: top} = view.toPixel(view.filmEye.set(x, y, z));
    const box = view.canvas.getBoundingClientRect();
    return [box.left + left, box.top + top];
  }, at);

/** Drags the mouse through places of a page's window. */
export async function drag(page, first, ...others) {
  await page.mouse.move(...first);
  await page.mouse.down();
  for (const at of others) await page.mouse.move(...at, {steps: 8});
  await page.mouse.up();
}
