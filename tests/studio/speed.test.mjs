// From a slider to the picture on the screen: figures, which are told and not judged, as they are the machine's.
import {before, test} from 'node:test';
import {browse, changed, parts, preset, shown, start, visit} from './studio.mjs';

const TIMES = 9;
let browser;
before(async () => (browser = await browse()));

const text = steps => `{
  "film": {"frames": 1, "size": [640, 400]},
  "scene": {"setting": "studio", "camera": {"location": [0, 0.9, 3], "look_at": [0, 0.5, 0]}},
  "organisms": [{"kind": "plant", "height": 1, "place": {"at": [[0, 0]]}, "smoothing": 1,
    "grammar": {"axiom": "A", "steps": ${steps}, "angle": 25, "rules": ["A -> F[+A]/A"]}}]
}`;

for (const [name, steps] of [['50,000', 15], ['500,000', 18]])
  test(`from slider to picture with ${name} nodes`, async () => {
    const studio = await start(preset(`${steps}.json`, text(steps)));
    const page = await visit(browser, studio.address);
    await shown(page);
    const slider = page.locator('[data-testid="row:organism/height"] input[type=range]');
    const took = [];
    for (let i = 0; i < TIMES; ++i) {
      const was = await parts(page);
      await slider.press('ArrowRight');
      await changed(page, was);
      await shown(page);
      took.push(await page.evaluate(() => window.frond.took()));
    }
    took.sort((a, b) => a - b);
    const {nodes, grown} = await page.evaluate(() => ({nodes: window.frond.view.header.nodes, grown: window.frond.view.header.seconds.grow}));
    const ms = seconds => `${Math.round(1000 * seconds)} ms`;
    console.log(`${nodes} nodes: ${ms(took[TIMES >> 1])} from slider to picture (median of ${TIMES}, least ${ms(took[0])}), of which growing ${ms(grown)}`);
    await page.context().close();
    await studio.stop();
  });
