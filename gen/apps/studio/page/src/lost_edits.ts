/** Edits of branches that find none, as after another seed. They stay in the preset, apart from those that are carried out. */

import { getAt, isObject } from "./pointer";
import type { Store } from "./store";

export interface LostEdit {
  entry: number;
  /** Which of the organism's edits it is. */
  index: number;
  /** "3/1:0.4, cut" */
  what: string;
  why: string;
}

const NOTE = /\/organisms\/(\d+)\/edits\/(\d+)\/\w+: (finds no .*)$/;

/** Those that the notes of a scene tell of. */
export function lostEdits(store: Pick<Store, "preset">, notes: readonly string[]): LostEdit[] {
  const found = new Map<string, LostEdit>();
  for (const note of notes) {
    const [, entry, index, why] = NOTE.exec(note) ?? [];
    if (entry === undefined) continue;
    const edit = getAt(store.preset.whole, ["organisms", Number(entry), "edits", Number(index)]);
    found.set(`${entry}/${index}`, { entry: Number(entry), index: Number(index), what: said(edit), why: why! });
  }
  return [...found.values()];
}

function said(edit: unknown): string {
  if (!isObject(edit)) return "";
  const act = edit.cut === true ? "cut" : typeof edit.cut === "number" ? `cut in year ${edit.cut}` : edit.bend !== undefined ? "bent" : edit.strength !== undefined ? `strength ${String(edit.strength)}` : edit.bare === true ? "bare" : edit.bark !== undefined ? "another bark" : "";
  return [String(edit.at ?? ""), act].filter(Boolean).join(", ");
}
