import { Color, Vector3 } from "three";
import type { Header, Vec3 } from "./header";
import type { Shared } from "./shared";

/** How each setting is lit: its sun, and what comes from all around as three colours, about. Surfaces throw back a good
 *  three quarters. */

interface Lamps {
  above: Color;
  aside: Color;
  below: Color;
  /** From where one looks. */
  eye: Color;
  sky: Sky;
}

/** Which gradient stands behind everything; the numbers are those of sky.ts. */
type Sky = 0 | 1 | 2;
export const WATER: Sky = 0;
export const OPEN: Sky = 1;
export const WALL: Sky = 2;

const FINISH = 0.76;
/** The view gives no light back from one thing to the next and has few shadows: so much of the sun makes up for both. */
const SUN = 0.8;

const color = (v: Vec3): Color => new Color().setRGB(...v);
/** A colour times one number plus another. */
const mixed = (c: Color, times: number, plus: number): Color => new Color(c.r * times + plus, c.g * times + plus, c.b * times + plus);

function under_water(sky: Color): Lamps {
  const water = sky.clone().multiplyScalar(1 / Math.max(sky.r, sky.g, sky.b, 1e-3));
  return {
    above: mixed(water, 0.6, 0.5),
    aside: mixed(water, 0.25, 0.08),
    below: new Color(0.5, 0.46, 0.38).multiplyScalar(0.24).add(mixed(water, 0.15, 0.02)),
    eye: mixed(water, 0.28, 0.2),
    sky: WATER,
  };
}

function in_the_open(sky: Color, horizon: Color, ground: Color): Lamps {
  const dim = Math.min(1, 0.02 + ((sky.r + horizon.r) * 0.3 + (sky.g + horizon.g) * 0.6 + (sky.b + horizon.b) * 0.1) / 1.25);
  return {
    above: mixed(sky, 0.27, 0.5).multiplyScalar(dim),
    aside: mixed(sky, 0.18, 0.2).multiplyScalar(dim),
    below: mixed(ground, 0.2, 0.1).multiplyScalar(dim),
    eye: mixed(sky, 0.08, 0.12).multiplyScalar(dim),
    sky: OPEN,
  };
}

const in_a_room = (): Lamps => ({
  above: new Color(0.4, 0.41, 0.42),
  aside: new Color(0.26, 0.27, 0.29),
  below: new Color(0.1, 0.1, 0.1),
  eye: new Color(0.08, 0.08, 0.08),
  sky: WALL,
});

function lampsOf(header: Header): Lamps {
  const { light } = header;
  const [sky, horizon, ground] = [light.sky, light.horizon, light.ground].map(color) as [Color, Color, Color];
  if (header.setting === "underwater") return under_water(sky);
  if (header.setting === "studio") return in_a_room();
  return in_the_open(sky, horizon, ground);
}

export function setLight(shared: Shared, header: Header): void {
  const { light } = header;
  const lamps = lampsOf(header);
  shared.sun.value.copy(new Vector3(...light.sun).normalize());
  shared.sun_light.value.copy(color(light.sunlight)).multiplyScalar(FINISH * SUN);
  shared.from_above.value.copy(lamps.above).multiplyScalar(FINISH);
  shared.from_aside.value.copy(lamps.aside).multiplyScalar(FINISH);
  shared.from_below.value.copy(lamps.below).multiplyScalar(FINISH);
  shared.from_eye.value.copy(lamps.eye).multiplyScalar(FINISH);
  shared.haze.value.set(...light.fog.color, light.fog.distance);
  shared.zenith.value.setRGB(...light.sky);
  shared.horizon.value.setRGB(...light.horizon);
  shared.sky_kind.value = lamps.sky;
}
