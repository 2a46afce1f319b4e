/** The engine in a thread of its own, which is stopped when it takes too long. */

import source from "frond-engine";

export interface Fault {
  where: string;
  what: string;
}

/** What the turtle draws; colours are indices. */
export interface Figure {
  errors: Fault[];
  notes: Fault[];
  /** Eight numbers each: x, y, z and radius of both ends. */
  segments: Float32Array;
  segmentColors: Int32Array;
  /** Nine numbers each. */
  triangles: Float32Array;
  triangleColors: Int32Array;
  /** Twelve numbers each: position, heading, left vector and scale. */
  sites: Float32Array;
  siteColors: Int32Array;
  siteNames: string[];
}

export interface Word {
  errors: Fault[];
  word: string;
  modules: number;
}

export interface Svg {
  errors: Fault[];
  svg: string;
}

/** A tree at one age. Light is that of the sun and that of the sky, 0..1 each. */
export interface Tree {
  errors: Fault[];
  /** Thirteen numbers each: x, y, z and radius of both ends, colour, light. */
  segments: Float32Array;
  /** Triangles of sprigs and flowers, six numbers a corner: place and normal. */
  shapes: Float32Array[];
  /** Of each shape, thirteen numbers each: place, turn, size, colour, light. */
  organs: Float32Array[];
  /** Light on a square of ground around the foot, two numbers each, row by row; half the side of that square in metres. */
  ground: Float32Array;
  groundHalf: number;
  /** Toward the sun. */
  sun: [number, number, number];
  /** Cycles of growth gone through by each year of its life, from 0 on. */
  cycles: Int32Array;
  /** As foresters count: metres, the stem at 1.3 m. */
  internodes: number;
  height: number;
  stem: number;
}

/** A coral at one share of its growth. */
export interface Coral {
  errors: Fault[];
  notes: Fault[];
  /** Thirteen numbers each, as of a tree; the last is how open it is there. */
  segments: Float32Array;
  /** Vertices of its bodies, three numbers each: where they are; ridge (1) or hollow (0), youth and openness. */
  places: Float32Array;
  normals: Float32Array;
  skin: Float32Array;
  /** Of triangles. */
  corners: Uint32Array;
  /** As of a tree. */
  ground: Float32Array;
  groundHalf: number;
  /** What its skin is wrought into, its colours (sRGB), and the width of a cup in metres. */
  matter: "cups" | "valleys" | "sponge";
  color: number[];
  second: number[];
  cup: number;
  relief: number;
  /** Metres, when it has grown. */
  size: [number, number, number];
}

interface Answers {
  draw: Figure;
  tree: Tree;
  coral: Coral;
  derive: Word;
  svg: Svg;
}

/** Milliseconds, once the engine has started. */
const PATIENCE = 5000;
const PATIENCE_WITH_GROWTH = 60_000;
/** Greatest number of modules and of segments of a grammar that has no limit of its own. */
const MODULES = 300_000;

const LOOP = `
const engine = frondEngine();
engine.then(() => postMessage({}));
onmessage = async ({ data }) => {
  try {
    postMessage({ answer: (await engine)[data.call](...data.words) });
  } catch (error) {
    postMessage({ broken: String(error) });
  }
};`;

let worker: Worker | null = null;
let ready: Promise<unknown> = Promise.resolve();
let queue: Promise<unknown> = Promise.resolve();

const next = (from: Worker): Promise<MessageEvent> =>
  new Promise((done, failed) => {
    from.onmessage = done;
    from.onerror = (event) => failed(new Error(event.message));
  });

function start(): Worker {
  const address = URL.createObjectURL(new Blob([source, LOOP], { type: "text/javascript" }));
  worker = new Worker(address);
  ready = next(worker);
  return worker;
}

function stop(): void {
  worker?.terminate();
  worker = null;
}

/** `less` is what helps where it takes too long. */
async function ask<Call extends keyof Answers>(call: Call, words: unknown[], patience: number, less: string): Promise<Answers[Call]> {
  const asked = worker ?? start();
  await ready;
  const wait = next(asked);
  asked.postMessage({ call, words });
  let timer = 0;
  const late = new Promise<never>((_, failed) => {
    timer = window.setTimeout(() => failed(new Error(`this takes longer than ${patience / 1000} seconds; ${less}`)), patience);
  });
  try {
    const { data } = await Promise.race([wait, late]);
    if (data.broken !== undefined) throw new Error(`this takes more memory than there is; ${less}`);
    return data.answer as Answers[Call];
  } catch (error) {
    stop();
    return { errors: [{ where: "", what: (error as Error).message }] } as unknown as Answers[Call];
  } finally {
    clearTimeout(timer);
  }
}

function call<Call extends keyof Answers>(...asked: [call: Call, words: unknown[], patience: number, less: string]): Promise<Answers[Call]> {
  const answer = queue.then(() => ask(...asked));
  queue = answer;
  return answer;
}

/** Calls a function of engine.cpp; one after the other. */
export const engine = <Call extends Exclude<keyof Answers, "tree" | "coral">>(name: Call, json: string, steps: number, modules = MODULES): Promise<Answers[Call]> =>
  call(name, [json, steps, modules], PATIENCE, "use fewer steps");

/** Greatest number of internodes that stand on a tree: with more it does not turn smoothly. */
export const INTERNODES = 150_000;

/** The tree of a preset, which grows where it is not the one that was asked for before. Age in whole years; `time` of the year, 0..1. */
export const treeOf = (json: string, seed: number, age: number, time: number): Promise<Tree> =>
  call("tree", [json, seed, INTERNODES, age, time], PATIENCE_WITH_GROWTH, "choose another tree");

/** The coral of a preset of that name, in about `share` of the time, at `grown` of its growth, both 0..1. It grows where it is not the
 *  one that was asked for before. */
export const coralOf = (json: string, name: string, share: number, grown: number): Promise<Coral> =>
  call("coral", [json, name, share, grown], PATIENCE_WITH_GROWTH, "make it smaller or its triangles larger");

/** Does what `once` does, and again for what is asked meanwhile, which is then done once more; at last what `after` does. */
export function latest(once: () => Promise<void>, after?: () => void): { draw: () => Promise<void>; busy: () => boolean } {
  let wanted = false, busy = false;
  const draw = async (): Promise<void> => {
    wanted = true;
    if (busy) return;
    busy = true;
    try {
      while (wanted) {
        wanted = false;
        await once();
      }
    } finally {
      busy = false;
    }
    after?.();
  };
  return { draw, busy: () => busy };
}
