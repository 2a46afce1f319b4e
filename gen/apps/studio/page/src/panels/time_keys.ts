/** The keys of what is selected, and those of the scene, on the timeline: each is dragged to another time, by arrow keys too. */

import { el } from "../dom";
import { spelled } from "../schema";
import type { Store } from "../store";
import { listsOf, moveKeys, removeKeys, type KeyPlace } from "./key_edits";

const GESTURE = "keys on the timeline";
/** Pixels that a press moves before it is a drag. */
const STILL = 3;

export function timeKeys(store: Store): HTMLElement {
  const element = el("div.marks", { role: "group", "aria-label": "Keys" });

  const move = (moved: KeyPlace[], time: number): number => moveKeys(store, moved, time, GESTURE);

  function drag(event: PointerEvent, time: number, moved: KeyPlace[]): void {
    const { width } = element.getBoundingClientRect();
    const from = event.clientX;
    let dragged = false;
    let now = time;
    const going = (e: PointerEvent): void => {
      dragged ||= Math.abs(e.clientX - from) > STILL;
      if (dragged) now = move(moved, time + ((e.clientX - from) / width) * store.preset.end);
    };
    element.setPointerCapture(event.pointerId);
    element.addEventListener("pointermove", going);
    element.addEventListener("lostpointercapture", () => {
      element.removeEventListener("pointermove", going);
      store.endGesture();
      if (!dragged) store.setTime(time);
      focus(now);
    }, { once: true });
    event.preventDefault();
  }

  const focus = (time: number): void => element.querySelector<HTMLElement>(`[data-time="${time}"]`)?.focus();

  function key(event: KeyboardEvent, time: number, at: KeyPlace[]): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step) {
      const now = move(at, time + (step * (event.shiftKey ? 10 : 1)) / store.preset.fps);
      store.endGesture();
      focus(now);
    } else if (event.key === "Delete") removeKeys(store, at);
    else if (event.key === "Enter") store.setTime(time);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  const refresh = (): void => {
    const { end } = store.preset;
    const places = new Map<number, KeyPlace[]>();
    for (const { path, keys } of listsOf(store))
      keys.forEach(([t], index) => t >= 0 && t <= end && places.set(t, [...(places.get(t) ?? []), { list: path, keys, index }]));
    const sorted = [...places].sort(([a], [b]) => a - b);
    element.replaceChildren(...sorted.map(([time, at]) => {
      const names = [...new Set(at.map(({ list }) => spelled(String(list.at(-1)))))].join(", ");
      const mark = el("button.mark", { type: "button", "aria-label": `Key at ${time} s: ${names}`, "data-tip": `${names} at ${time} s: drag it, or move it by arrow keys; Delete removes it`, "data-time": String(time), "data-testid": `time-key:${time}`,
        pointerdown: (event: PointerEvent) => event.button === 0 && drag(event, time, at), keydown: (event: KeyboardEvent) => key(event, time, at) });
      mark.style.left = `${(100 * time) / Math.max(end, 1e-6)}%`;
      return mark;
    }));
  };
  store.on(["text", "selected"], refresh);
  return element;
}
