/** What organisms are made of, as a part of a preset that another organism can take over. */

import * as api from "./api";
import { setAt } from "./edits";
import { isObject } from "./pointer";
import { Preset } from "./preset";
import type { Field, PresetSchema } from "./schema";
import type { Store } from "./store";

/** The properties of all kinds that say what their surface is. */
const OF_MATERIAL = ["coat", "bark", "leaves", "skin", "tissue", "stone", "brick", "mortar", "paint", "weathering", "matter", "material", "color", "second", "variation", "gloss", "crackle", "bands", "moss", "look"];

export interface Material {
  /** The preset and the organism that it is of. */
  file: string;
  name: string;
  kind: string;
  values: Record<string, unknown>;
}

/** The part of what an organism says that its surface is made of. */
export const materialOf = (said: Record<string, unknown>): Record<string, unknown> =>
  Object.fromEntries(OF_MATERIAL.filter((name) => said[name] !== undefined).map((name) => [name, said[name]]));

/** Those of the organisms of a preset that say what they are made of. */
function materialsIn(file: string, text: string): Material[] {
  const preset = new Preset(text);
  return preset.organisms.flatMap((_, entry) => {
    const values = materialOf(preset.organism(entry));
    return Object.keys(values).length ? [{ file, name: preset.nameOf(entry), kind: preset.kindOf(entry), values }] : [];
  });
}

/** Those of some presets, each once. */
export async function materialsOf(files: string[]): Promise<Material[]> {
  const texts = await Promise.all(files.map((file) => api.preset(file).catch(() => null)));
  const seen = new Set<string>();
  return texts.flatMap((loaded, i) => (loaded ? materialsIn(files[i]!, loaded.text) : [])).filter(({ kind, values }) => {
    const key = JSON.stringify([kind, values]);
    return !seen.has(key) && seen.add(key) !== undefined;
  });
}

/** Folders whose presets are no organisms to take over. */
const NOT_THESE = /^(asking|grammars|models)\//;
let shipped: Promise<Material[]> | null = null;

/** Those of all presets that are shipped, read once. */
export const shippedMaterials = (presets: api.Listed[]): Promise<Material[]> => (shipped ??= materialsOf(presets.filter((p) => !NOT_THESE.test(p.name)).map(({ file }) => file)));

/** A preset with nothing but one organism of that material, for its picture. */
export const exampleOf = ({ file, kind, values }: Material): api.Doc => ({ file, text: JSON.stringify({ film: { frames: 1 }, scene: { setting: "studio" }, organisms: [{ kind, ...values }] }) });

/** What of a material an organism of that kind can have, name by name. */
export function fitsOf(schema: PresetSchema, { kind, values }: Material, other: string): (readonly [string, unknown])[] {
  const [given, fields] = [schema.kind(kind).fields, schema.kind(other).fields];
  return Object.entries(values).map(([name, value]) => [name, fitting(value, given.get(name), fields.get(name))] as const).filter(([, value]) => value !== undefined);
}

/** Of each material that a kind can have, its leaves or all else that the surface is, each once. */
export function partsFor(schema: PresetSchema, all: Material[], kind: string, what: "leaves" | "surface"): Material[] {
  const seen = new Set<string>();
  return all.map((one) => ({ ...one, values: Object.fromEntries(Object.entries(one.values).filter(([name]) => (name === "leaves") === (what === "leaves"))) }))
    .filter((one) => {
      // Leaves of other kinds have other properties.
      const key = JSON.stringify(one.values);
      const fits = fitsOf(schema, one, kind).length > 0 && (what === "surface" || namesIn(schema, one.kind) === namesIn(schema, kind));
      return fits && !seen.has(key) && seen.add(key) !== undefined;
    });
}

const namesIn = (schema: PresetSchema, kind: string): string => {
  const leaves = schema.kind(kind).fields.get("leaves");
  return leaves?.type === "object" ? [...leaves.fields.keys()].join() : "";
};

/** Gives organisms what of a material their kinds can have, as one step; answers how many took something. */
export function applyMaterial(store: Store, material: Material, entries: number[]): number {
  let took = 0;
  store.batch((text) => entries.reduce((out, entry) => {
    const fits = fitsOf(store.schema, material, store.preset.kindOf(entry));
    if (fits.length) ++took;
    return fits.reduce((inner, [name, value]) => setAt(store.writtenOut(inner, ["organisms", entry, name]), ["organisms", entry, name], value), out);
  }, text));
  return took;
}

/** A value as another kind has that property: a stone may be a colour or more than that. undefined: it does not fit. */
function fitting(value: unknown, from: Field | undefined, to: Field | undefined): unknown {
  if (isObject(value) && typeof value.photo === "string") return undefined; // a photograph lies beside the preset that it is of
  if (from?.type === to?.type) return value;
  if (from?.type === "color" && to?.type === "object" && to.fields.get("color")?.type === "color") return { color: value };
  if (from?.type === "object" && to?.type === "color" && isObject(value)) return value.color;
  return undefined;
}
