// What a person drags in the view: plantings, keys of paths, the camera, and files from outside.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {browse, changed, drag, parts, pixelOf, preset, scratch, shown, start, visit} from './studio.mjs';

const TEXT = `{
  "film": {"frames": 48, "fps": 24, "size": [320, 240]},
  "scene": {"setting": "studio", "camera": {
    "location": [[0, [0, 1.2, 3]], [2, [1, 1.2, 3]]], "look_at": [0, 0.3, 0], "angle": 50}},
  "organisms": [
    {"kind": "coral", "name": "coral", "height": 0.5, "place": {"at": [[-0.5, 0.2], [0.5, 0]]},
      "food": {"strength": 20, "position": [[0, [-0.4, 0.8, 0.5]], [2, [0.9, 0.9, 0.2]]]}}
  ]
}`;

let page, studio;
before(async () => {
  studio = await start(preset('staging.json', TEXT), '--assets', scratch);
  page = await visit(await browse(), studio.address);
  await shown(page);
});
after(() => studio.stop());

const text = () => page.evaluate(() => document.querySelector('[data-testid="text"]').value);
const now = async () => JSON.parse(await text());

const pixel = at => pixelOf(page, at);

const near = (is, should, within) =>
  is.forEach((x, i) => assert.ok(Math.abs(x - should[i]) < within, `${JSON.stringify(is)} lies not near ${JSON.stringify(should)}`));

test('a planting is dragged over the ground', async () => {
  await page.getByTestId('tab:text').click();
  await page.getByTestId('organism:0').click();
  const was = await parts(page);
  // By the dot at its foot.
  const grip = await pixel(await page.evaluate(() => window.frond.view.header.specimens[1].foot));
  const foot = await pixel([0.5, 0, 0]), goal = await pixel([0.2, 0, 0.6]);
  await drag(page, grip, grip.map((x, i) => x + goal[i] - foot[i]));
  await changed(page, was);
  const {place} = (await now()).organisms[0];
  assert.deepEqual(place.at[0], [-0.5, 0.2]);
  near(place.at[1], [0.2, 0.6], 0.08);
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT);
  await shown(page);
});

test('a key of the food is dragged, the others stay', async () => {
  const key = [0.9, 0.9, 0.2], from = await pixel(key);
  await drag(page, from, [from[0] - 40, from[1] + 30]);
  const {position} = (await now()).organisms[0].food;
  assert.deepEqual(position[0], [0, [-0.4, 0.8, 0.5]]);
  assert.ok(Math.hypot(...position[1][1].map((x, i) => x - key[i])) > 0.05);
  near(await pixel(position[1][1]), [from[0] - 40, from[1] + 30], 2);
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT);
  await shown(page);
});

test("the camera's way has keys once the scene is chosen", async () => {
  await page.getByTestId('part:scene').click();
  await page.evaluate(() => {
    // From aside, as the preset's camera stands in the eye.
    const {view} = window.frond;
    view.camera.position.set(4, 3, 6);
    return view.drawn();
  });
  const from = await pixel([1, 1.2, 3]);
  await drag(page, from, [from[0] + 25, from[1] - 20]);
  const {location} = (await now()).scene.camera;
  assert.deepEqual(location[0], [0, [0, 1.2, 3]]);
  near(await pixel(location[1][1]), [from[0] + 25, from[1] - 20], 2);
  await page.getByTestId('undo').click();
  assert.equal(await text(), TEXT);
  await shown(page);
});

test('an OBJ file that is dropped stands where it fell', async () => {
  const was = await parts(page);
  const [x, y] = await pixel([0.4, 0, 0.8]);
  const data = await page.evaluateHandle(() => {
    const data = new DataTransfer();
    const side = (a, b, c) => `f ${a} ${b} ${c}`;
    const corners = ['v 0 0 0', 'v 0.4 0 0', 'v 0 0 0.4', 'v 0.1 0.5 0.1'];
    const faces = [side(1, 2, 3), side(1, 4, 2), side(2, 4, 3), side(3, 4, 1)];
    data.items.add(new File([[...corners, ...faces].join('\n')], 'stone.obj'));
    return data;
  });
  await page.dispatchEvent('[data-testid="view"]', 'drop', {dataTransfer: data, clientX: x, clientY: y});
  await changed(page, was);
  const made = (await now()).organisms.at(-1);
  assert.equal(made.kind, 'mesh');
  near(made.place.at[0], [0.4, 0.8], 0.05);
  assert.ok(fs.existsSync(path.resolve(scratch, made.file)), made.file);
  assert.deepEqual(page.faults, []);
});

test('a mesh is dropped with its materials, a second beside it, and what is no mesh is refused', async () => {
  const files = (await now()).organisms.length;
  const folder = fs.readdirSync(scratch);
  const drop = async list => {
    const data = await page.evaluateHandle(list => {
      const data = new DataTransfer();
      for (const [name, text] of list) data.items.add(new File([text], name));
      return data;
    }, list);
    await page.dispatchEvent('[data-testid="view"]', 'drop', {dataTransfer: data, clientX: 400, clientY: 300});
  };
  const tetrahedron = 'v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nusemtl oak\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n';
  const facet = (...corners) => `facet normal 0 0 1\nouter loop\n${corners.map(at => `vertex ${at}`).join('\n')}\nendloop\nendfacet\n`;
  await drop([['cask.mtl', 'newmtl oak\nKd 1 0 0\n'], ['cask.obj', `mtllib cask.mtl\n${tetrahedron}`], ['chip.stl', `solid chip\n${facet('0 0 0', '1 0 0', '0 1 0')}endsolid chip\n`]]);
  await page.getByText('chip.stl stands in the scene').waitFor();
  await shown(page);
  const made = (await now()).organisms.slice(files);
  assert.deepEqual(made.map(one => [one.name, one.file]), [['cask', 'cask/cask.obj'], ['chip', 'chip.stl']]);
  near([made[1].place.at[0][0] - made[0].place.at[0][0]], [1], 0.02);
  assert.match(fs.readFileSync(path.resolve(scratch, 'cask/cask.mtl'), 'utf8'), /Kd 1 0 0/);
  // The colour of the material is seen.
  const colors = await page.evaluate(entry => JSON.stringify(window.frond.view.header.parts.filter(part => part.entry === entry).map(part => part.material ?? part)), files);
  assert.match(colors, /\[1,0,0\]/);
  await drop([['tree.blend', 'BLENDER-v300']]);
  await page.getByText('a file of Blender').waitFor();
  await drop([['oak.png', 'no mesh']]);
  await page.getByText('oak.png is no mesh').waitFor();
  assert.equal((await now()).organisms.length, files + 2);
  assert.deepEqual(fs.readdirSync(scratch).filter(name => !folder.includes(name)).sort(), ['cask', 'chip.stl']);
  assert.deepEqual(page.faults.filter(fault => !fault.includes('400')), []);
});

test('what the graphics card forgets is shown anew', async () => {
  const was = await parts(page);
  await page.evaluate(() => {
    const card = window.frond.view.painter.renderer.getContext().getExtension('WEBGL_lose_context');
    card.loseContext();
    return new Promise(done => {
      window.frond.view.canvas.addEventListener('webglcontextrestored', done);
      setTimeout(() => card.restoreContext(), 0);
    });
  });
  await shown(page);
  assert.equal(await parts(page), was);
  assert.ok((await page.evaluate(() => window.frond.mask(32, 24))).length > 200);
});
