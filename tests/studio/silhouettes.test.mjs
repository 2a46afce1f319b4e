// What stands in the view is what POV-Ray draws: silhouettes from the preset's camera overlap. Both see the organisms
// alone, in a studio without its walls.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {before, test} from 'node:test';
import {browse, frond, preset, shown, start, visit} from './studio.mjs';

const LEAST = 0.97;
let browser;
before(async () => (browser = await browse()));

/** POV-Ray's picture of the first frame, with nothing where no organism is. */
function povray(file) {
  const folder = `${file}.out`;
  execFileSync(frond, ['generate', file, '-o', folder, '--frames', '1-1', '-q'], {stdio: ['ignore', 'inherit', 'ignore']});
  const frames = path.join(folder, 'frames');
  const scene = fs.readFileSync(path.join(frames, 'frame_0001.pov'), 'utf8').split('\n').filter(line => !line.startsWith('Studio_Room('));
  const bare = path.join(folder, 'bare.pov');
  const picture = path.join(folder, 'bare.png');
  fs.writeFileSync(bare, scene.join('\n'));
  const size = /\+W\d+ \+H\d+/.exec(scene[0])[0].split(' ');
  execFileSync('povray', ['+Lpovinc', `+L${frames}`, `+I${bare}`, `+O${picture}`, ...size, '+Q1', '+UA', '-A', '-D', '-GA'], {stdio: 'ignore'});
  return fs.readFileSync(picture).toString('base64');
}

/** The share of pixels of either that are of both. Runs in the page, which can read pictures. */
async function overlap(address) {
  const pixels = async from => {
    const image = new Image();
    image.src = from;
    await image.decode();
    const pen = new OffscreenCanvas(image.width, image.height).getContext('2d');
    pen.drawImage(image, 0, 0);
    return pen.getImageData(0, 0, image.width, image.height);
  };
  const drawn = await pixels(address);
  const ours = await pixels(await window.frond.mask(drawn.width, drawn.height));
  let both = 0;
  let either = 0;
  for (let i = 0; i < drawn.data.length; i += 4) {
    const [a, b] = [drawn.data[i + 3] > 127, ours.data[i] > 127];
    both += a && b;
    either += a || b;
  }
  return {share: both / either, either};
}

for (const name of ['staghorn', 'trees/oak', 'ivy/brick_wall', 'garden/rocks'])
  test(name, async () => {
    const text = fs.readFileSync(`presets/${name}.json`, 'utf8').replace(/"setting":\s*"\w+"/, '"setting": "studio"')
      .replace(/"film":\s*\{/, '"film": {"twigs": 0, ')  // the view has each twig as it is
      .replace(/"years": \d+/, '"years": 60')  // an old tree takes a browser without a graphics card minutes
      .replace('"angle": 52', '"angle": 20');  // leaves of a few pixels, whose rims are not all that is seen
    const file = preset(`${path.basename(name)}.json`, text);
    const studio = await start(file);
    const page = await visit(browser, studio.address, {viewport: {width: 640, height: 420}});
    await shown(page);
    const {share, either} = await page.evaluate(overlap, `data:image/png;base64,${povray(file)}`);
    console.log(`${name}: ${(100 * share).toFixed(2)} % of ${either} pixels`);
    assert.ok(either > 1000);
    assert.ok(share >= LEAST);
    await page.context().close();
    await studio.stop();
  });
