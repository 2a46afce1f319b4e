/** What of a preset a picture may scale: where it stands there, and what it is laid on. */

import { Matrix4, Vector3 } from "three";
import { getAt, isObject, type Path } from "../pointer";
import { round } from "../rounding";
import type { Store } from "../store";
import type { View } from "../view/view";

export type Axis = "x" | "y" | "z";
type Corner = [number, number];

/** How a picture lies in the world: along an axis, over a rectangle of the other two (see gen/base/core/mask.h). */
export interface Projection {
  along: Axis;
  low: Corner;
  high: Corner;
}

export interface Maskable {
  value: string;
  label: string;
  path: Path;
  /** Organisms that it is laid on, or the ground. */
  on: number[] | "ground";
  /** What is written beside a new picture. */
  beside: Record<string, unknown>;
}

/** Settings that read each map of the land. */
const LAND_MAPS: { path: Path; label: string; settings: string[]; needs?: Path }[] = [
  { path: ["scene", "meadow", "grass_map"], label: "the grass", settings: ["meadow", "garden"] },
  { path: ["scene", "forest", "moss_map"], label: "the moss of the ground", settings: ["forest"] },
  { path: ["scene", "snow", "depth_map"], label: "the snow", settings: ["meadow", "garden", "forest"], needs: ["scene", "snow", "depth"] },
];
const WIDEST = 60; // metres of land that a new map covers as a whole
const NEAR = 20; // metres from the middle that it covers of wider land

export function maskables(store: Store, view: View): Maskable[] {
  const { preset, schema } = store;
  const setting = String(getAt(preset.whole, ["scene", "setting"]) ?? "");
  const organisms = preset.organisms.flatMap((_, entry): Maskable[] => {
    const name = preset.nameOf(entry);
    const { fields } = schema.kind(preset.kindOf(entry));
    const stone = fields.get("stone");
    const crawl = fields.get("crawl");
    const own: Path = ["organisms", entry];
    const found: Maskable[] = [];
    if (isObject(preset.organism(entry).sown)) found.push({ value: `sown ${entry}`, label: `where ${name} grows`, path: [...own, "sown", "where", "map"], on: "ground", beside: {} });
    if (crawl?.type === "object" && crawl.fields.has("mask"))
      found.push({ value: `ivy ${entry}`, label: `where ${name} creeps`, path: [...own, "crawl", "mask"], on: hostsOf(store, view, entry), beside: { stops: 0.5 } });
    if (stone?.type === "object" && stone.fields.has("moss_map")) found.push({ value: `moss ${entry}`, label: `the moss on ${name}`, path: [...own, "stone", "moss_map"], on: [entry], beside: {} });
    return found;
  });
  const land = LAND_MAPS.filter((map) => map.settings.includes(setting) && (!map.needs || getAt(preset.whole, map.needs) !== undefined));
  return [...organisms, ...land.map(({ path, label }): Maskable => ({ value: path.join("/"), label, path, on: "ground", beside: {} }))];
}

/** What ivy grows on: the organisms that it names, or all others. */
export function hostsOf(store: Store, view: View, entry: number): number[] {
  const { on } = store.preset.organism(entry);
  const names = Array.isArray(on) ? on.map(String) : [];
  return (view.head?.entries ?? []).flatMap((e, i) => (i !== entry && (!names.length || names.includes(e.name)) ? [i] : []));
}

/** The picture's name and all that is written with it. */
export function written(store: Store, mask: Maskable): Record<string, unknown> {
  const value = getAt(store.preset.whole, mask.path);
  if (typeof value === "string") return { file: value };
  return isObject(value) ? value : {};
}

const corner = (value: unknown): value is Corner => Array.isArray(value) && typeof value[0] === "number" && typeof value[1] === "number";

/** How the picture that there is lies; null where it is not projected, or there is none. */
export function projectionOf(store: Store, view: View, mask: Maskable): Projection | null {
  const { file, along, area } = written(store, mask);
  if (!file) return null;
  if (mask.on !== "ground" && along === undefined && mask.path.includes("crawl")) return null;
  const axis = along === "x" || along === "z" ? along : "y";
  if (Array.isArray(area) && corner(area[0]) && corner(area[1])) {
    const [a, b] = area;
    return { along: axis, low: [Math.min(a[0], b[0]), Math.min(a[1], b[1])], high: [Math.max(a[0], b[0]), Math.max(a[1], b[1])] };
  }
  if (mask.on !== "ground") return onHosts(view, mask.on, axis);
  const half = (view.head?.land ?? 0) / 2;
  return { along: axis, low: [-half, -half], high: [half, half] };
}

/** How a new picture lies, by the way one looks. */
export function newProjection(view: View, mask: Maskable): Projection | null {
  if (mask.on !== "ground") {
    const way = view.middle().ray.direction;
    const axes: [Axis, number][] = [["x", Math.abs(way.x)], ["y", Math.abs(way.y)], ["z", Math.abs(way.z)]];
    return onHosts(view, mask.on, axes.reduce((a, b) => (b[1] > a[1] ? b : a))[0]);
  }
  const land = view.head?.land ?? 0;
  if (!land) return null;
  const half = mask.path.includes("sown") || land <= WIDEST ? land / 2 : NEAR;
  return { along: "y", low: [-half, -half], high: [half, half] };
}

/** The box of organisms, seen along an axis. */
function onHosts(view: View, entries: number[], along: Axis): Projection | null {
  const boxes = entries.flatMap((i) => view.head?.entries[i] ?? []).filter((e) => e.low[0] <= e.high[0]);
  if (!boxes.length) return null;
  const [low, high] = [[0, 1, 2].map((k) => Math.min(...boxes.map((b) => b.low[k]!))), [0, 1, 2].map((k) => Math.max(...boxes.map((b) => b.high[k]!)))];
  const [a, b] = ACROSS[along];
  return { along, low: [round(low[a]!), round(low[b]!)], high: [round(high[a]!), round(high[b]!)] };
}

/** Which coordinates are across a picture and along its other side. */
const ACROSS: Record<Axis, [number, number]> = { x: [2, 1], y: [0, 2], z: [0, 1] };

/** A place of the world as shares of a picture's width, from the left, and height, from the top. */
export function onPicture(p: Projection, at: Vector3): [number, number] {
  const [a, b] = ACROSS[p.along];
  const across = (at.getComponent(a) - p.low[0]) / Math.max(p.high[0] - p.low[0], 1e-6);
  const other = (at.getComponent(b) - p.low[1]) / Math.max(p.high[1] - p.low[1], 1e-6);
  return [across, p.along === "y" ? other : 1 - other];
}

/** onPicture() as a matrix. */
export function pictureMatrix(p: Projection): Matrix4 {
  const zero = onPicture(p, new Vector3());
  const steps = [0, 1, 2].map((k) => onPicture(p, new Vector3().setComponent(k, 1)));
  const row = (i: 0 | 1): [number, number, number, number] => [steps[0]![i] - zero[i], steps[1]![i] - zero[i], steps[2]![i] - zero[i], zero[i]];
  return new Matrix4().set(...row(0), ...row(1), 0, 0, 0, 0, 0, 0, 0, 1);
}
