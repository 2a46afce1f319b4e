/**
 * A preset as its text says: its own values, those of its base, and what counts for each organism. The laws are those
 * of docs/presets.md: an organism's own value wins over the scene's in `defaults`, but a property that `force` names
 * has the scene's value for all, or, where the scene has none, the built-in one. What its species says counts as its own
 * where it says nothing itself.
 */

import { parse, printParseErrorCode, type ParseError } from "jsonc-parser";
import type { Fault } from "./api";
import { getAt, isObject, type Path } from "./pointer";

type Json = Record<string, unknown>;

/** `own` over `below`: objects member by member, lists and all else as a whole. */
export function overlay(below: unknown, own: unknown): unknown {
  if (own === undefined) return below;
  if (!isObject(below) || !isObject(own)) return own;
  const merged: Json = { ...below };
  for (const [key, value] of Object.entries(own)) merged[key] = overlay(below[key], value);
  return merged;
}

/** Makes `own` (which may be changed) agree with `defaults` in a property such as "wave" or "wave/amplitude". */
function forcePath(defaults: unknown, own: unknown, path: string[]): void {
  if (!isObject(own)) return;
  const [name, ...rest] = path as [string, ...string[]];
  const wanted = isObject(defaults) ? defaults[name] : undefined;
  if (rest.length) forcePath(wanted, own[name], rest);
  else if (wanted !== undefined) own[name] = wanted;
  else delete own[name];
}

/** Is something there? A plain value on the way stands for what it is short for. */
function names(value: unknown, path: Path): boolean {
  const above = path.findIndex((_, i) => {
    const at = getAt(value, path.slice(0, i));
    return at !== undefined && !isObject(at);
  });
  return above >= 0 || getAt(value, path) !== undefined;
}

/** Whose value counts for a property of an organism. */
export type Scope = "own" | "species" | "all" | "unset";

/** What an organism has of its own, however it may be told by a species: how many stand where. */
const NEVER_OF_SPECIES = { own: ["count", "group", "sown", "species"], place: ["at", "on", "center", "inner", "radius"] };

/** Kinds that others stand on or beside. */
export const LIFELESS = new Set(["rock", "pebbles", "wall", "column", "mesh", "bridge", "vase", "trellis"]);

/** What the preset of a species says of those that name it: all of its first organism but where that stands. */
export function speciesIn(preset: Preset): Json | null {
  if (!preset.organisms.length) return null;
  const kind = structuredClone(preset.organism(0));
  for (const name of NEVER_OF_SPECIES.own) delete kind[name];
  if (isObject(kind.place)) for (const name of NEVER_OF_SPECIES.place) delete kind.place[name];
  return kind;
}

export class Preset {
  readonly own: Json;
  /** With its base below it. */
  readonly whole: Json;
  readonly syntax: ParseError[] = [];
  private merged = new Map<number, Json>();

  constructor(
    readonly text: string,
    readonly base: Json = {},
    /** What a species says, by the name that an organism has for it. */
    private speciesOf: (name: string) => Json | undefined = () => undefined,
  ) {
    const value: unknown = parse(text, this.syntax, { allowTrailingComma: false });
    this.own = isObject(value) ? value : {};
    this.whole = overlay(base, this.own) as Json;
  }

  get organisms(): Json[] {
    const list = this.whole.organisms;
    return Array.isArray(list) ? list.map((o) => (isObject(o) ? o : {})) : [];
  }

  get defaults(): Json {
    return isObject(this.whole.defaults) ? this.whole.defaults : {};
  }

  get force(): string[] {
    return Array.isArray(this.whole.force) ? this.whole.force.filter((f) => typeof f === "string") : [];
  }

  /** When the film's last picture is taken, seconds: all has grown by then. */
  get end(): number {
    return Math.max(0, (Number(this.film.frames ?? 72) - 1) / this.fps) || 0;
  }

  get fps(): number {
    return Number(this.film.fps ?? 24) || 24;
  }

  private get film(): Json {
    return isObject(this.whole.film) ? this.whole.film : {};
  }

  get title(): string {
    return typeof this.whole.title === "string" ? this.whole.title : "";
  }

  nameOf(entry: number): string {
    const { name, kind } = this.described(entry);
    return String(name || kind || `organism ${entry + 1}`);
  }

  kindOf(entry: number): string {
    return String(this.described(entry).kind ?? "");
  }

  /** The preset that it names as its species; empty: none. */
  speciesName(entry: number): string {
    const name = this.organisms[entry]?.species;
    return typeof name === "string" ? name : "";
  }

  /** The name that it is listed under with others; empty: none. */
  groupOf(entry: number): string {
    const name = this.organisms[entry]?.group;
    return typeof name === "string" ? name : "";
  }

  /** The organism that a picture is of: what its camera is set to; what its title names; else the first that lives. */
  get subject(): number {
    const all = [...this.organisms.keys()];
    const camera = getAt(this.whole, ["scene", "camera"]);
    const named = (name: unknown): number => all.findIndex((i) => typeof name === "string" && this.nameOf(i) === name);
    const fit = getAt(camera, ["fit"]);
    const meant = [getAt(camera, ["focus"]), ...(Array.isArray(fit) ? fit : [fit])].map(named).find((i) => i >= 0);
    if (meant !== undefined) return meant;
    const words = new Set(this.title.toLowerCase().split(/[^\p{L}\d]+/u).flatMap((word) => [word, word.replace(/s$/, "")]));
    const titled = (i: number): boolean => [this.nameOf(i), this.kindOf(i)].some((name) => words.has(name.toLowerCase().replace(/s$/, "")));
    const lives = (i: number): boolean => !LIFELESS.has(this.kindOf(i));
    const found = [(i: number) => titled(i) && lives(i), titled, lives].map((is) => all.find(is)).find((i) => i !== undefined);
    return found ?? 0;
  }

  inGroup(name: string): number[] {
    return [...this.organisms.keys()].filter((i) => this.groupOf(i) === name);
  }

  /** What its species says; empty where it has none, or that is not known yet. */
  ofSpecies(entry: number): Json {
    const name = this.speciesName(entry);
    return (name && this.speciesOf(name)) || {};
  }

  /** What it says itself over what its species says. */
  private described(entry: number): Json {
    const own = this.organisms[entry] ?? {};
    return this.speciesName(entry) ? (overlay(this.ofSpecies(entry), own) as Json) : own;
  }

  /** All that counts for an organism. */
  organism(entry: number): Json {
    let found = this.merged.get(entry);
    if (!found) this.merged.set(entry, (found = this.overDefaults(this.described(entry))));
    return found;
  }

  /** The same without what its species says, which may not be known yet. */
  ownOf(entry: number): Json {
    return this.overDefaults(this.organisms[entry] ?? {});
  }

  private overDefaults(described: Json): Json {
    const all = structuredClone(overlay(this.defaults, described)) as Json;
    for (const path of this.force) forcePath(this.defaults, all, path.split("/"));
    return all;
  }

  /** Does `force` name the property, or what it is a part of? */
  isForced(property: Path): boolean {
    const path = property.join("/");
    return this.force.some((f) => path === f || path.startsWith(f + "/"));
  }

  scope(entry: number, property: Path): Scope {
    if (this.isForced(property)) return "all";
    if (names(this.organisms[entry], property)) return "own";
    if (names(this.ofSpecies(entry), property)) return "species";
    return names(this.defaults, property) ? "all" : "unset";
  }

  /** Mistakes that keep the text from being read at all. */
  get faults(): Fault[] {
    return (this.told ??= this.syntax.map((error) => this.fault(error)));
  }
  private told: Fault[] | undefined;

  private fault(error: ParseError): Fault {
    const before = this.text.slice(0, error.offset);
    const line = before.split("\n").length;
    const column = error.offset - before.lastIndexOf("\n");
    const said = printParseErrorCode(error.error).replace(/([a-z])([A-Z])/g, "$1 $2").toLowerCase();
    return { text: `JSON: ${said}`, where: `${line}:${column}`, line, column, pointer: "" };
  }
}

/** The file that a preset in `file` means by `name`. */
export function beside(file: string, name: string): string {
  if (name.startsWith("/")) return name;
  const parts = file.split("/").slice(0, -1);
  for (const part of name.split("/")) {
    if (part === ".." && parts.length && parts.at(-1) !== "..") parts.pop();
    else if (part !== ".") parts.push(part);
  }
  return parts.join("/");
}
