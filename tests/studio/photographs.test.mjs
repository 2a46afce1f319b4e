// A leaf and bark of photographs: a real server, a real browser, a real mouse, and the keyboard.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {browse, changed, parts, preset, scratch, shown, start, visit} from './studio.mjs';

const TEXT = `{
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio", "camera": {"location": [0, 1, 3], "look_at": [0, 0.6, 0], "angle": 40}},
  "organisms": [
    {"kind": "colonized", "name": "crown", "count": 1, "colonize": {"attractors": 60}, "envelope": {"height": 1.2, "width": 1},
     "place": {"at": [[0, 0]], "size_variation": 0, "lean": 0},
     "coat": {"pixels": 64}, // bark
     "leaves": {"colors": ["#805020"], "size": 0.2}}
  ]
}
`;
let page, studio;
before(async () => {
  studio = await start(preset('photographs.json', TEXT));
  page = await visit(await browse(), studio.address, {viewport: {width: 1280, height: 800}});
  await shown(page);
});
after(async () => {
  assert.deepEqual(page.faults, []);
  await page.context().close();
  await studio.stop();
});

/** A green leaf with a stalk, lying aslant on noisy grey, as a PNG of 200 x 200. */
const photograph = async () => {
  const address = await page.evaluate(() => {
    const canvas = Object.assign(document.createElement('canvas'), {width: 200, height: 200});
    const context = canvas.getContext('2d');
    context.fillStyle = '#b8b8c0';
    context.fillRect(0, 0, 200, 200);
    context.translate(100, 100);
    context.rotate(Math.PI / 4);
    context.fillStyle = '#3c8c28';
    context.beginPath();
    context.ellipse(0, -10, 30, 60, 0, 0, 2 * Math.PI);
    context.fill();
    context.fillRect(-2, 45, 4, 40);
    const pixels = context.getImageData(0, 0, 200, 200);
    for (let i = 0; i < pixels.data.length; ++i) if (i % 4 < 3) pixels.data[i] += ((i * 2654435761) % 1009) / 1009 * 16 - 8;
    context.putImageData(pixels, 0, 0);
    return canvas.toDataURL('image/png');
  });
  return {name: 'leaf.png', mimeType: 'image/png', buffer: Buffer.from(address.split(',')[1], 'base64')};
};
const result = read => page.getByTestId('photo-result').evaluate(read);
const click = async (x, y) => {
  const {width} = await page.getByTestId('photo').boundingBox();
  await page.getByTestId('photo').click({position: {x: (x + 0.5) * width / 200, y: (y + 0.5) * width / 200}});
};
const text = async () => {
  await page.evaluate(() => dispatchEvent(new Event('pagehide')));
  return page.evaluate(() => JSON.parse(sessionStorage.getItem('frond.draft')).text);
};
const json = async () => JSON.parse((await text()).replace(/\/\/.*/g, ''));
async function open(group) {
  await page.getByTestId('organism:0').click();
  await page.getByTestId('search').fill('photo');
  await page.getByTestId(`row:organism/${group}/photo`).getByTestId('use-photograph').click();
  await page.getByTestId('photo-file').setInputFiles(await photograph());
  await page.waitForFunction(() => document.querySelector('[data-testid=photo]').width === 200);
}

test('a leaf is cut out, turned upright and used, and that is one step to undo', async () => {
  const was = await parts(page);
  await open('leaves');
  await click(10, 10);
  // Foot and tip, one by the mouse and one by the keyboard.
  await page.getByTestId('photo:foot').click();
  await click(40, 160);
  await page.getByTestId('photo:tip').click();
  await page.getByTestId('photo-x').fill('148');
  await page.getByTestId('photo-y').fill('50');
  await page.getByTestId('photo').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  const [width, height, corner, middle] = await result(c => [c.width, c.height, c.getContext('2d').getImageData(2, 2, 1, 1).data[3],
    [...c.getContext('2d').getImageData(c.width / 2, c.height * 0.4, 1, 1).data]]);
  assert.ok(Math.abs(height - 155) < 8 && Math.abs(width - 62) < 10, `${width} x ${height}`);
  assert.equal(corner, 0);
  assert.ok(middle[1] > middle[0] + 40 && middle[3] === 255, `${middle}`);

  // What was cut away is put back, and that is undone.
  await page.getByTestId('photo:back').click();
  await click(10, 10);
  assert.ok((await result(c => c.width)) > 100);
  await page.getByTestId('photo-undo').click();
  assert.equal(await result(c => c.width), width);
  // The other half; it is as wide then on both sides.
  await page.getByTestId('photo-half').selectOption('left');
  const row = await result(c => [...c.getContext('2d').getImageData(0, Math.round(c.height / 3), c.width, 1).data].filter((_, i) => i % 4 === 3));
  assert.deepEqual(row, row.toReversed());
  await page.getByTestId('photo-balance').selectOption('background');

  await page.getByTestId('answer:use').click();
  await page.getByTestId('photograph').waitFor({state: 'detached'});
  const {leaves} = (await json()).organisms[0];
  assert.match(leaves.photo, /\.png$/);
  assert.equal(leaves.colors, undefined);
  assert.equal(fs.readFileSync(path.join(scratch, leaves.photo)).subarray(1, 4).toString(), 'PNG');
  await changed(page, was);
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT);
});

test('a piece of bark is chosen by its corners', async () => {
  await open('coat');
  await click(60, 40);
  await page.getByTestId('photo:to').click();
  await click(140, 160);
  const [width, height] = await result(c => [c.width, c.height]);
  assert.ok(Math.abs(width - 80) < 3 && Math.abs(height - 120) < 3, `${width} x ${height}`);
  await page.getByTestId('answer:use').click();
  await page.getByTestId('photograph').waitFor({state: 'detached'});
  assert.match((await json()).organisms[0].coat.photo, /\.png$/);
  await shown(page);
});
