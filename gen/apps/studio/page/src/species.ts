/** Species: presets whose first organism others are laid over. */

import * as api from "./api";
import { renameAt, setAt } from "./edits";
import { isObject, type Path } from "./pointer";
import { beside, overlay, Preset, speciesIn } from "./preset";

type Json = Record<string, unknown>;
const DEEPEST = 8;

/** What a preset says with its bases below it; the server tells what is wrong with one when it grows the preset. */
export async function readWithBases(name: string): Promise<Json> {
  let all: unknown = undefined;
  try {
    for (let file = name, depth = 0; file && depth < DEEPEST; depth++) {
      const { own } = new Preset((await api.preset(file)).text);
      all = all === undefined ? own : overlay(own, all);
      file = typeof own.base === "string" ? beside(file, own.base) : "";
    }
  } catch {
    // What was read so far is shown.
  }
  return isObject(all) ? all : {};
}

/** What the species in a file says; null where that is none. */
export const readSpecies = async (file: string): Promise<Json | null> => speciesIn(new Preset(JSON.stringify(await readWithBases(file))));

/** A file as it is named in a preset that lies elsewhere. */
export function relativeTo(preset: string, file: string): string {
  const from = preset.split("/").slice(0, -1);
  const to = file.split("/");
  let same = 0;
  while (same < from.length && same < to.length - 1 && from[same] === to[same]) same++;
  return [...from.slice(same).map(() => ".."), ...to.slice(same)].join("/");
}

const isFile = (value: unknown): value is string => typeof value === "string" && /\.(obj|svg|png|xml|json)$/.test(value) && !value.startsWith("/");

/** A value whose files are named from elsewhere. */
function moved(value: unknown, name: (file: string) => string): unknown {
  if (isFile(value)) return name(value);
  if (Array.isArray(value)) return value.map((v) => moved(v, name));
  if (!isObject(value)) return value;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, moved(inner, name)]));
}

/** The text with all that a species says written into the organism at `path`, which says `own` so far, in place of its name. */
export function withSpecies(text: string, path: Path, own: unknown, species: Json, name: (file: string) => string): string {
  const { kind, ...rest } = species;
  const saysKind = isObject(own) && own.kind !== undefined;
  let out = saysKind ? text : renameAt(text, [...path, "species"], "kind", kind);
  if (saysKind) out = renameAt(text, [...path, "species"], null, null);
  const write = (at: Path, mine: unknown, values: Json): void => {
    for (const [key, value] of Object.entries(values)) {
      const there = isObject(mine) ? mine[key] : undefined;
      if (there === undefined) out = setAt(out, [...at, key], moved(value, name));
      else if (isObject(there) && isObject(value)) write([...at, key], there, value);
    }
  };
  write(path, own, rest);
  return out;
}
