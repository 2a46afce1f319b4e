/** Small pictures of presets: one view out of sight draws them, one after the other. */

import * as api from "../api";
import { el, sleep } from "../dom";
import { View } from "../view/view";

const WIDTH = 360;
/** How much of the view the preset's frame takes. */
const FRAME = 0.94;
/** Seconds that one may take to grow. */
const PATIENCE = 20;
const NOTHING = (): void => {};

type Shown = Pick<api.SceneRequest, "time" | "solo" | "hide">;
/** What of a canvas is the preset's frame. */
export interface Cut {
  from: HTMLCanvasElement;
  width: number;
  height: number;
}

/** Draws each and hands it over, or says why there is none; ends where `over` says so. */
export async function drawPictures(docs: api.Doc[], aspect: number, shown: Shown, over: AbortSignal, take: (index: number, drawn: Cut | string) => void): Promise<void> {
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
  try {
    for (let i = 0; i < docs.length && !over.aborted; i++) {
      const answer = await api.scene(session, (asked = i + 1), { doc: docs[i]!, ...shown, have: view.have(), ask: PATIENCE }, over);
      if (over.aborted) break;
      if (answer.is !== "picture") {
        take(i, answer.is === "long" ? "too large" : "cannot be grown");
        continue;
      }
      view.show(answer.bytes);
      await there;
      // In the very frame that draws it, as it is not kept for longer.
      await view.drawn();
      void view.drawn();
      await new Promise(requestAnimationFrame);
      const from = host.querySelector("canvas")!;
      const across = FRAME * Math.min(from.width, from.height * aspect);
      take(i, { from, width: across, height: across / aspect });
    }
  } catch (error) {
    if (over.aborted) void api.leaveScene(session, asked).catch(NOTHING); // nobody waits for what is growing
    else docs.forEach((_, i) => take(i, (error as Error).message));
  } finally {
    view.dispose();
    host.remove();
  }
}

export function copyTo(to: HTMLCanvasElement, { from, width, height }: Cut): void {
  to.width = width;
  to.height = height;
  to.getContext("2d")?.drawImage(from, (from.width - width) / 2, (from.height - height) / 2, width, height, 0, 0, width, height);
}
