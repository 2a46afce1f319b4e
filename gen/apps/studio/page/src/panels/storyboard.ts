/** The film in a row of small pictures: quick looks, and frames of a film that is being rendered as they are finished. */

import * as api from "../api";
import { el, quiet } from "../dom";
import type { Store } from "../store";

const COUNT = 12;

export interface Storyboard {
  element: HTMLElement;
  /** Draws what is missing, while it is seen. */
  show(seen: boolean): void;
  /** Shows the finished frames of that film; null: quick looks alone. */
  showFrames(film: api.FilmState | null): void;
}

/** Times over a film, the first and the last frame among them. */
export function timesOver(end: number, fps: number, most = COUNT): number[] {
  const last = Math.round(end * fps);
  const count = Math.min(most, last + 1);
  return Array.from({ length: count }, (_, i) => Math.round((last * i) / Math.max(count - 1, 1)) / fps);
}

/** The finished frame nearest to a time, no farther than `within` frames; null: none is so near. */
export function frameNear(there: number[], time: number, fps: number, within: number): number | null {
  const wanted = time * fps + 1;
  const nearest = there.reduce<number | null>((best, n) => (best === null || Math.abs(n - wanted) < Math.abs(best - wanted) ? n : best), null);
  return nearest !== null && Math.abs(nearest - wanted) <= within ? nearest : null;
}

export function storyboard(store: Store): Storyboard {
  const element = el("ol.storyboard", { "aria-label": "Storyboard", "data-testid": "storyboard" });
  let times: number[] = [];
  let pictures: HTMLImageElement[] = [];
  let looks: (string | null)[] = [];
  let drawn = "";
  let running = "";
  let seen = false;
  let frames: api.FilmState | null = null;

  const lay = (): void => {
    const wanted = timesOver(store.preset.end, store.preset.fps);
    if (wanted.join() === times.join()) return;
    times = wanted;
    looks = times.map(() => null);
    pictures = times.map(() => el<HTMLImageElement>("img", { alt: "" }));
    element.replaceChildren(...times.map((time, i) => el("li", {}, el("button", { type: "button", "data-testid": `moment:${i}`, "aria-label": `Go to ${time.toFixed(2)} seconds`, click: () => store.setTime(time) }, pictures[i], el("span", {}, time.toFixed(2))))));
    mark();
  };
  const mark = (): void => {
    const nearest = times.reduce((best, t, i) => (Math.abs(t - store.time) < Math.abs(times[best]! - store.time) ? i : best), 0);
    element.querySelectorAll("button").forEach((button, i) => button.setAttribute("aria-current", String(i === nearest)));
  };
  const fill = (): void => {
    const step = times.length > 1 ? times[1]! - times[0]! : 0;
    pictures.forEach((picture, i) => {
      const frame = frames && frameNear(frames.there, times[i]!, frames.fps, (step * frames.fps) / 2);
      const source = frame ? api.filmFile(frames!.id, frame) : looks[i];
      picture.parentElement!.classList.toggle("rendered", Boolean(frame));
      picture.hidden = !source;
      if (source && picture.src !== new URL(source, location.href).href) picture.src = source;
    });
  };
  /** One after the other, as long as nothing changes meanwhile. */
  async function draw(): Promise<void> {
    const { text, doc } = store;
    if (!seen || !store.isOpen || drawn === text || running === text || store.scene.busy || !store.scene.header) return;
    running = text;
    lay();
    const size = store.scene.header.film.size;
    element.style.setProperty("--aspect", String(size[0] / size[1]));
    for (const [i, time] of times.entries()) {
      const picture = await api.moment(doc, time).catch(() => null);
      if (store.text !== text || !seen) break;
      if (!picture) continue;
      if (looks[i]) URL.revokeObjectURL(looks[i]);
      looks[i] = URL.createObjectURL(picture);
      fill();
      if (i === times.length - 1) drawn = text;
    }
    running = "";
  }
  const later = quiet(400, () => void draw());
  store.on(["scene", "text"], later);
  store.on("time", mark);
  return {
    element,
    show(now): void {
      seen = now;
      if (seen) lay();
      later();
    },
    showFrames(film): void {
      frames = film;
      fill();
    },
  };
}
