/** What a stroke in the view may become: lines of points in the preset, each with its way between the preset and the world. */

import { Quaternion, Vector3 } from "three";
import { keysOf, shapeOf, type Key } from "../keyframes";
import { getAt, isObject, type Path } from "../pointer";
import { round, rounded } from "../rounding";
import type { Store } from "../store";
import type { View } from "../view/view";
import type { Knot } from "./spline";
import { hostsOf } from "./masks";

/** A point of a line with its handles, in the world, and where it stands in the preset. */
export interface StrokePoint extends Knot {
  path: Path;
  /** What else the preset says of it. */
  rest: Record<string, unknown>;
  /** Of a way in time: the key that it is. */
  key?: Key;
}

export interface StrokeLine {
  points: StrokePoint[];
  smooth: boolean;
  closed: boolean;
  /** Of a way in time: all of its keys. */
  keys?: Key[];
}

export interface Stroke {
  value: string;
  label: string;
  /** Where the pointer draws: in the plane that faces the eye through a place, on the ground, or on organisms. */
  on: { plane: Vector3 } | "ground" | number[];
  /** Metres of width that is asked for with it, if it has one. */
  width?: number;
  /** How strongly it leads what follows it, 0..1, if that is asked for. */
  pull?: number;
  lines(): StrokeLine[];
  /** A new line. */
  draw(points: Vector3[], width: number, pull: number): void;
  /** What a place of the world is in the preset. */
  spelled(at: Vector3): number[];
}

const EYE_HEIGHT = 1.6; // metres of a person
const spot = (at: Vector3): number[] => rounded(at.toArray());
const flat = (at: Vector3): number[] => [round(at.x), round(at.z)];

const numbers = (value: unknown, n: number): value is number[] => Array.isArray(value) && value.length >= n && value.slice(0, n).every((x) => typeof x === "number");

/** All that can be drawn for what is selected, and for the scene. */
export function strokesFor(store: Store, view: View): Stroke[] {
  const { selected } = store;
  const own = typeof selected === "number" ? [guideOf(store, view, selected), strandOf(store, view, selected)] : [];
  return [...own, pathOf(store, view), bedOf(store, view), wayOf(store, view)].filter((s) => s !== null);
}

/** The line whose points stand there; `n` numbers each. */
function lineAt(store: Store, path: Path, place: (value: number[]) => Vector3, n: number, smooth = false, closed = false): StrokeLine {
  const value = getAt(store.preset.whole, path);
  const points = (Array.isArray(value) ? (value as unknown[]) : []).flatMap((item, i): StrokePoint[] => {
    const { at, in: back, out, ...rest } = isObject(item) ? item : { at: item };
    if (!numbers(at, n)) return [];
    const here = place(at);
    const handle = (way: unknown): Vector3 | undefined => (numbers(way, n) ? place(at.map((x, k) => x + way[k]!)).sub(here) : undefined);
    return [{ at: here, in: handle(back), out: handle(out), path: [...path, i], rest }];
  });
  return { points, smooth, closed };
}

/** The line that a tree, plant or coral grows along, from its foot, in its own axes. */
function guideOf(store: Store, view: View, entry: number): Stroke | null {
  const { fields } = store.schema.kind(store.preset.kindOf(entry));
  const stands = view.head?.specimens.find((s) => s.entry === entry);
  const grammar = fields.get("grammar");
  const inner: Path | null = fields.has("guide") ? ["guide"] : grammar?.type === "object" && grammar.fields.has("guide") && isObject(store.preset.organism(entry).grammar) ? ["grammar", "guide"] : null;
  if (!inner || !stands) return null;
  const foot = new Vector3(...stands.foot);
  const turn = new Quaternion(...stands.turn);
  const back = turn.clone().invert();
  const path: Path = ["organisms", entry, ...inner, "points"];
  const spelled = (at: Vector3): number[] => spot(at.clone().sub(foot).applyQuaternion(back).divideScalar(stands.size));
  return {
    value: "guide",
    label: `a guide of ${store.preset.nameOf(entry)}`,
    on: { plane: foot },
    lines: () => [lineAt(store, path, (v) => new Vector3(...(v as [number, number, number])).multiplyScalar(stands.size).applyQuaternion(turn).add(foot), 3)],
    // It begins above the foot, which is its own first place.
    draw: (points) => store.set(path, points.filter((p) => p.distanceTo(foot) > 0.02).map(spelled)),
    spelled,
  };
}

/** A line that strands follow over what they grow on. */
function strandOf(store: Store, view: View, entry: number): Stroke | null {
  const crawl = store.schema.kind(store.preset.kindOf(entry)).fields.get("crawl");
  if (crawl?.type !== "object" || !crawl.fields.has("guides")) return null;
  const path: Path = ["organisms", entry, "crawl", "guides"];
  const given = (): unknown[] => {
    const list = getAt(store.preset.organism(entry), ["crawl", "guides"]);
    return Array.isArray(list) ? (list as unknown[]) : [];
  };
  return {
    value: "strand",
    label: `a way for ${store.preset.nameOf(entry)}`,
    on: hostsOf(store, view, entry),
    width: 0.1,
    pull: 1,
    lines: () => given().map((guide, i) => lineAt(store, [...path, i, "points"], (v) => new Vector3(...(v as [number, number, number])), 3, isObject(guide) && guide.curve === true)),
    draw: (points, width, pull) => store.set([...path, given().length], { width, ...(pull < 1 ? { pull } : {}), curve: true, points: points.map(spot) }),
    spelled: spot,
  };
}

const inGarden = (store: Store): boolean => getAt(store.preset.whole, ["scene", "setting"]) === "garden";

/** Heights of the ground are not in the preset: a point lies where the ground was when it was drawn, else level. */
function onGround(view: View, [x, z]: number[]): Vector3 {
  return new Vector3(x, view.heightAt(x!, z!), z);
}

function pathOf(store: Store, view: View): Stroke | null {
  if (!inGarden(store)) return null;
  const path: Path = ["scene", "garden", "path", "points"];
  return {
    value: "path",
    label: "the garden's path",
    on: "ground",
    width: 1.2,
    lines: () => [lineAt(store, path, (v) => onGround(view, v), 2, true)],
    draw: (points, width) =>
      store.batch((text) => store.edited(store.edited(text, path, points.map(flat)), ["scene", "garden", "path", "width"], width)),
    spelled: flat,
  };
}

function bedOf(store: Store, view: View): Stroke | null {
  if (!inGarden(store)) return null;
  const path: Path = ["scene", "garden", "areas"];
  const given = (): unknown[] => {
    const list = getAt(store.preset.whole, path);
    return Array.isArray(list) ? (list as unknown[]) : [];
  };
  return {
    value: "bed",
    label: "the outline of a bed",
    on: "ground",
    lines: () => given().map((area, i) => lineAt(store, [...path, i, "outline"], (v) => onGround(view, v), 2, isObject(area) && area.curve === true, true)),
    draw: (points) => points.length > 2 && store.set([...path, given().length], { kind: "earth", outline: points.map(flat) }),
    spelled: flat,
  };
}

/** The camera goes along it while the film lasts, at the height of a person's eyes. */
function wayOf(store: Store, view: View): Stroke {
  const path: Path = ["scene", "camera", "location"];
  const follows = getAt(store.preset.whole, ["scene", "camera", "follow"]) === true;
  return {
    value: "way",
    label: "the camera's way",
    on: "ground",
    lines: () => {
      const keys = keysOf(getAt(store.preset.whole, path));
      if (!keys || follows || !keys.every(([, at]) => numbers(at, 3))) return [];
      const vector = (v: number[] | undefined): Vector3 | undefined => v && new Vector3(...(v as [number, number, number]));
      const points = keys.map((key, i): StrokePoint => ({ at: vector(key[1] as number[])!, in: vector(shapeOf(key).in), out: vector(shapeOf(key).out), path: [...path, i], rest: {}, key }));
      return [{ points, smooth: false, closed: false, keys }];
    },
    draw: (points) => {
      const far = points.map((p, i) => (i ? p.distanceTo(points[i - 1]!) : 0));
      const whole = far.reduce((sum, d) => sum + d, 0);
      let gone = 0;
      const keys = points.map((p, i) => {
        gone += far[i]!;
        const eye = [round(p.x), round((follows ? 0 : view.heightAt(p.x, p.z)) + EYE_HEIGHT), round(p.z)];
        return [round((store.preset.end * gone) / Math.max(whole, 1e-6)), eye];
      });
      if (keys.length > 1 && whole > 0 && store.preset.end > 0) store.set(path, keys);
    },
    spelled: spot,
  };
}
