/** Grammars that stand in files of their own. */

import { getAt, type Path } from "./pointer";
import { beside } from "./preset";
import type { Store } from "./store";

/** What of a grammar is read from the preset where a file has the rest. */
const BESIDE_MODEL = ["file", "steps", "limits", "vary"];
const BESIDE_RULES = ["file", "organs"];

/** The file that an organism's grammar is read from, as the server finds it; null: its rules stand in the preset. */
export function grammarFileOf(store: Store, entry: number): string | null {
  const name = getAt(store.preset.organism(entry), ["grammar", "file"]);
  if (typeof name !== "string" || !name) return null;
  const ofSpecies = store.preset.scope(entry, ["grammar", "file"]) === "species";
  return beside(ofSpecies ? beside(store.file, store.preset.speciesName(entry)) : store.file, name);
}

/** Is it a model of cpfg, which has all in its files? */
export const isModel = (file: string): boolean => file.endsWith(".l");

/** Does a property of an organism do anything beside the file of its grammar? */
export function countsBesideFile(store: Store, entry: number, [first, name]: Path): boolean {
  const file = first === "grammar" && name !== undefined ? grammarFileOf(store, entry) : null;
  return file === null || (isModel(file) ? BESIDE_MODEL : BESIDE_RULES).includes(String(name));
}
