/** The keys of what is selected, and those of the scene, on the timeline: each is dragged to another time, by arrow keys too. */

import { Binding } from "../controls/binding";
import { el } from "../dom";
import { keyLists, type Key } from "../keyframes";
import { setAt } from "../edits";
import type { Path } from "../pointer";
import { spelled } from "../schema";
import type { Store } from "../store";

/** A key in the preset: the list that it stands in, and where. */
interface Place {
  list: Path;
  keys: Key[];
  index: number;
}

const GESTURE = "keys on the timeline";
/** Pixels that a press moves before it is a drag. */
const STILL = 3;

export function timeKeys(store: Store): HTMLElement {
  const element = el("div.marks", { role: "group", "aria-label": "Keys" });

  /** Those of the scene, and of the organism that is selected or of what applies to all. */
  const allLists = (): { path: Path; keys: Key[] }[] => {
    const { selected, preset } = store;
    const scene = keyLists(preset.whole.scene, ["scene"]);
    if (typeof selected !== "number") return [...scene, ...keyLists(preset.defaults, ["defaults"])];
    return [...scene, ...keyLists(preset.organism(selected)).map(({ path, keys }) => ({ path: new Binding(store, selected, path).path, keys }))];
  };

  /** How far the keys may go: not past those beside them, nor out of the film. */
  const limits = (moved: Place[]): [number, number] => {
    const frame = 1 / store.preset.fps;
    const before = moved.map(({ keys, index }) => (keys[index - 1]?.[0] ?? -frame) + frame);
    const after = moved.map(({ keys, index }) => (keys[index + 1]?.[0] ?? store.preset.end + frame) - frame);
    return [Math.max(...before), Math.min(...after)];
  };

  /** Moves keys to the frame nearest to a time; the time that they have then. */
  function move(moved: Place[], time: number): number {
    const [least, most] = limits(moved);
    const frame = Math.round(time * store.preset.fps) / store.preset.fps;
    const t = Number(Math.max(least, Math.min(most, frame)).toFixed(3));
    const text = moved.reduce((out, { list, index }) => setAt(store.writtenOut(out, [...list, index, 0]), [...list, index, 0], t), store.text);
    store.change(text, GESTURE);
    return t;
  }

  /** The middle of its list is left when a key goes; the last one of a list stays. */
  function remove(at: Place[]): void {
    const lists = at.filter(({ keys }) => keys.length > 1);
    store.batch((text) => lists.reduce((out, { list, keys, index }) => setAt(store.writtenOut(out, [...list, 0]), list, keys.filter((_, i) => i !== index)), text));
  }

  function drag(event: PointerEvent, time: number, moved: Place[]): void {
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

  function key(event: KeyboardEvent, time: number, at: Place[]): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step) {
      const now = move(at, time + (step * (event.shiftKey ? 10 : 1)) / store.preset.fps);
      store.endGesture();
      focus(now);
    } else if (event.key === "Delete") remove(at);
    else if (event.key === "Enter") store.setTime(time);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  const refresh = (): void => {
    const { end } = store.preset;
    const places = new Map<number, Place[]>();
    for (const { path, keys } of allLists())
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
