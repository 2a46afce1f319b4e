/** The keys of what is selected, and those of the scene, in the preset: found, moved in time, taken out. */

import { Binding } from "../controls/binding";
import { removeAt, setAt } from "../edits";
import { keyLists, shapeOf, type Ease, type Key } from "../keyframes";
import type { Path } from "../pointer";
import type { Store } from "../store";

export interface KeyList {
  path: Path;
  keys: Key[];
}
/** A key in the preset: the list that it stands in, and where. */
export interface KeyPlace {
  list: Path;
  keys: Key[];
  index: number;
}

/** Those of the scene, and of the organism that is selected or of what applies to all. */
export function listsOf(store: Store): KeyList[] {
  const { selected, preset } = store;
  const scene = keyLists(preset.whole.scene, ["scene"]);
  if (typeof selected !== "number") return [...scene, ...keyLists(preset.defaults, ["defaults"])];
  return [...scene, ...keyLists(preset.organism(selected)).map(({ path, keys }) => ({ path: new Binding(store, selected, path).path, keys }))];
}

/** How far keys may go: not past those beside them, nor out of the film. */
function limits(store: Store, moved: KeyPlace[]): [number, number] {
  const frame = 1 / store.preset.fps;
  const before = moved.map(({ keys, index }) => (keys[index - 1]?.[0] ?? -frame) + frame);
  const after = moved.map(({ keys, index }) => (keys[index + 1]?.[0] ?? store.preset.end + frame) - frame);
  return [Math.max(...before), Math.min(...after)];
}

/** The frame nearest to a time that keys may have. */
export function timeFor(store: Store, moved: KeyPlace[], time: number): number {
  const [least, most] = limits(store, moved);
  const frame = Math.round(time * store.preset.fps) / store.preset.fps;
  return Number(Math.max(least, Math.min(most, frame)).toFixed(3));
}

/** A text with another time (0), value (1) or ease (2) of a key; in a vector, with another number. */
export function withPart(store: Store, text: string, { list, index }: KeyPlace, part: Path, value: unknown): string {
  const path = [...list, index, ...part];
  return setAt(store.writtenOut(text, path), path, value);
}

/** Moves keys to the frame nearest to a time; the time that they have then. */
export function moveKeys(store: Store, moved: KeyPlace[], time: number, gesture: string): number {
  const t = timeFor(store, moved, time);
  store.change(moved.reduce((text, place) => withPart(store, text, place, [0], t), store.text), gesture);
  return t;
}

/** The last key of a list stays. */
export function removeKeys(store: Store, at: KeyPlace[]): void {
  const lists = at.filter(({ keys }) => keys.length > 1);
  store.batch((text) => lists.reduce((out, { list, index }) => removeAt(store.writtenOut(out, [...list, index]), [...list, index]), text));
}

/** Sets how the way to the next key begins and ends; null: as fast as at the keys beside it. */
export function setEase(store: Store, place: KeyPlace, ease: Ease | null): void {
  const { list, keys, index } = place;
  const { in: back, out } = shapeOf(keys[index]!);
  const path = [...list, index, 2];
  if (back || out) store.set(path, { ...(ease ? { ease } : {}), ...(back ? { in: back } : {}), ...(out ? { out } : {}) });
  else if (ease) store.batch((text) => withPart(store, text, place, [2], ease));
  else store.remove(path);
}
