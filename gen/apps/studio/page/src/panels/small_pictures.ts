/** Small pictures of presets: one view out of sight draws them, one after the other. */

import * as api from "../api";
import { el, sleep } from "../dom";
import { View } from "../view/view";

const WIDTH = 360;
/** How much of the view the preset's frame takes. */
const FRAME = 0.94;
/** Seconds that one may take to grow. */
const PATIENCE = 20;
/** Of the time that it takes, where all are shown roughly first. */
const ROUGH = 1 / 8;
/** Pictures that make one that is finished. */
const FINE = 2;
const NOTHING = (): void => {};

type Shown = Pick<api.SceneRequest, "time" | "solo" | "hide">;
/** What of a canvas is the preset's frame. */
export interface Cut {
  from: HTMLCanvasElement;
  width: number;
  height: number;
}
/** Takes a picture, or why there is none; `finished`: no finer one comes. */
type Take = (index: number, drawn: Cut | string, finished: boolean) => void;

export interface Order {
  aspect: number;
  shown: Shown;
  /** All are shown roughly first, of so many organisms each; then each as it will be. */
  roughly?: number;
  /** Which one is at work. */
  begin?: (index: number) => void;
}

/** Draws each and hands it over; ends where `over` says so. */
export async function drawPictures(docs: api.Doc[], { aspect, shown, roughly, begin }: Order, over: AbortSignal, take: Take): Promise<void> {
  const host = el("div.offscreen", { "aria-hidden": "true", inert: true });
  const width = Math.round(WIDTH * Math.min(1, aspect));
  host.style.width = `${width}px`;
  host.style.height = `${Math.round(width / aspect)}px`;
  document.body.append(host);
  const view = new View(host, { picked: NOTHING, placed: NOTHING, key: NOTHING, camera: NOTHING });
  view.lookThrough(true);
  const there = sleep(600); // it flies there
  const session = crypto.randomUUID();
  let asked = 0;

  /** Whether it is as it will be. */
  async function draw(i: number, more: Partial<api.SceneRequest>): Promise<boolean> {
    const answer = await api.scene(session, ++asked, { doc: docs[i]!, ...shown, have: view.have(), ask: PATIENCE, ...more }, over);
    if (over.aborted) return true;
    if (answer.is !== "picture") {
      take(i, answer.is === "long" ? "too large" : "cannot be grown", true);
      return true;
    }
    const { coarse, missing } = view.show(answer.bytes);
    const finished = !coarse && !missing.length;
    await there;
    // As it is while something moves, leaves and flowers are left out.
    await view.drawn();
    view.finely(finished ? FINE : 1);
    const from = host.querySelector("canvas")!;
    const across = FRAME * Math.min(from.width, from.height * aspect);
    take(i, { from, width: across, height: across / aspect }, finished);
    return finished;
  }

  try {
    let left = [...docs.keys()];
    const rounds = roughly ? [{ only: Array.from({ length: roughly }, (_, k) => k), share: ROUGH }, {}] : [{}];
    for (const more of rounds) {
      const unfinished: number[] = [];
      for (const i of left) {
        if (over.aborted) break;
        begin?.(i);
        if (!(await draw(i, more))) unfinished.push(i);
      }
      left = unfinished;
    }
  } catch (error) {
    if (!over.aborted) docs.forEach((_, i) => take(i, (error as Error).message, true));
  } finally {
    if (over.aborted) void api.leaveScene(session, asked).catch(NOTHING); // nobody waits for what is growing
    view.dispose();
    host.remove();
  }
}

export function copyTo(to: HTMLCanvasElement, { from, width, height }: Cut): void {
  to.width = width;
  to.height = height;
  to.getContext("2d")?.drawImage(from, (from.width - width) / 2, (from.height - height) / 2, width, height, 0, 0, width, height);
}
