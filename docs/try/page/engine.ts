/** The grammar engine in a thread of its own, which is stopped when it takes too long. */

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

interface Answers {
  draw: Figure;
  derive: Word;
  svg: Svg;
}

/** Milliseconds, once the engine has started. */
const PATIENCE = 5000;
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

async function ask<Call extends keyof Answers>(call: Call, json: string, steps: number, modules: number): Promise<Answers[Call]> {
  const asked = worker ?? start();
  await ready;
  const wait = next(asked);
  asked.postMessage({ call, words: [json, steps, modules] });
  let timer = 0;
  const late = new Promise<never>((_, failed) => {
    timer = window.setTimeout(() => failed(new Error(`this takes longer than ${PATIENCE / 1000} seconds; use fewer steps`)), PATIENCE);
  });
  try {
    const { data } = await Promise.race([wait, late]);
    if (data.broken !== undefined) throw new Error("this takes more memory than there is; use fewer steps");
    return data.answer as Answers[Call];
  } catch (error) {
    stop();
    return { errors: [{ where: "", what: (error as Error).message }] } as unknown as Answers[Call];
  } finally {
    clearTimeout(timer);
  }
}

/** Calls a function of engine.cpp; one after the other. */
export function engine<Call extends keyof Answers>(call: Call, json: string, steps: number, modules = MODULES): Promise<Answers[Call]> {
  const answer = queue.then(() => ask(call, json, steps, modules));
  queue = answer;
  return answer;
}
