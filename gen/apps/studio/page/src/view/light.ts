import { Color, Vector3 } from "three";
import type { Header, Vec3 } from "./header";
import { BACKDROP_STOPS, type Shared } from "./shared";

/** Surfaces throw back a good three quarters. */
const FINISH = 0.76;
/** The view gives no light back from one thing to the next and has few shadows: so much of the sun makes up for both. */
const SUN = 0.8;

const color = (v: Vec3): Color => new Color().setRGB(...v);

/** Takes the light of a scene from its header; the server knows how each setting is lit. */
export function setLight(shared: Shared, header: Header): void {
  const { light } = header;
  shared.sun.value.copy(new Vector3(...light.sun).normalize());
  shared.sun_light.value.copy(color(light.sunlight)).multiplyScalar(FINISH * SUN);
  shared.from_above.value.copy(color(light.fill.above)).multiplyScalar(FINISH);
  shared.from_aside.value.copy(color(light.fill.aside)).multiplyScalar(FINISH);
  shared.from_below.value.copy(color(light.fill.below)).multiplyScalar(FINISH);
  shared.from_eye.value.copy(color(light.fill.eye)).multiplyScalar(FINISH);
  shared.haze.value.set(...light.fog.color, light.fog.distance);
  for (let i = 0; i < BACKDROP_STOPS; ++i) {
    const stop = light.backdrop[Math.min(i, light.backdrop.length - 1)]!;
    shared.backdrop.value[i]!.set(...stop.light, stop.height);
  }
}
