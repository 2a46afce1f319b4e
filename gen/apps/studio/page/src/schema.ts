/** What a value of the preset may be, read from the JSON Schema in the words that controls need. */

import { isObject, type Path } from "./pointer";

type Schema = Record<string, unknown>;

interface Common {
  /** What it is for, without its unit. */
  doc: string;
  unit: string;
  /** undefined: the schema names none. */
  default?: unknown;
}
export interface NumberField extends Common {
  type: "number";
  low: number;
  high: number;
  integer: boolean;
}
export interface EnumField extends Common {
  type: "enum";
  options: { value: string; doc: string }[];
}
export interface ListField extends Common {
  type: "list";
  item: Field;
  least: number;
  most: number;
}
export interface ObjectField extends Common {
  type: "object";
  fields: Map<string, Field>;
  /** A plain value in place of the object stands for this member. */
  shorthand?: string;
}
export interface VectorField extends Common {
  type: "vector";
  items: NumberField[];
}
export interface KeyedField extends Common {
  type: "keyed";
  base: Field;
}
export interface PlainField extends Common {
  type: "boolean" | "text" | "color" | "curve" | "map" | "any";
}
export type Field = NumberField | EnumField | ListField | ObjectField | VectorField | KeyedField | PlainField;

const UNIT = /\s*\((m|degrees|s|1\/s|1\/m2|h|years|pixels|m, [^)]*)\)$/;
const UNIT_SIGNS: Record<string, string> = { degrees: "°", pixels: "px", "1/m2": "1/m²" };

function commonOf(schema: Schema): Common {
  const text = String(schema.description ?? "");
  const unit = UNIT.exec(text)?.[1] ?? "";
  return { doc: text.replace(UNIT, ""), unit: UNIT_SIGNS[unit] ?? unit, default: schema.default };
}

/** "What it is. coral: a coral; plant: a plant" tells what each option is. */
function optionsOf(schema: Schema, doc: string): EnumField["options"] {
  const names = schema.enum as string[];
  const starts = names.map((name) => {
    const at = new RegExp(`(?:^|[.;] )${name}: `).exec(doc);
    return { name, at: at ? at.index : -1, from: at ? at.index + at[0].length : -1 };
  });
  return starts.map(({ name, at, from }) => {
    if (at < 0) return { value: name, doc: "" };
    const ends = starts.map((s) => s.at).filter((a) => a > at);
    return { value: name, doc: doc.slice(from, ends.length ? Math.min(...ends) : undefined) };
  });
}

const isNumber = (schema: Schema): boolean => schema.type === "number" || schema.type === "integer";
const isColor = (options: Schema[]): boolean => options.length === 2 && String(options[0]!.pattern ?? "").startsWith("^#");

/** A list of [time, value]: what may change over the film. */
function isKeys(schema: Schema): boolean {
  const items = (schema.items as Schema | undefined)?.items;
  return schema.type === "array" && Array.isArray(items) && items.length >= 2;
}

function numberOf(schema: Schema, common = commonOf(schema)): NumberField {
  const low = Number(schema.minimum ?? schema.exclusiveMinimum ?? -Infinity);
  return { ...common, type: "number", low, high: Number(schema.maximum ?? Infinity), integer: schema.type === "integer" };
}

/** Whether a list of [x, y] of that name is a curve rather than places or keys. */
export const isCurve = (name: string): boolean => /^(curve|profile)$|_along$/.test(name);

function arrayOf(schema: Schema, name: string): Field {
  const common = commonOf(schema);
  const items = (schema.items ?? {}) as Schema;
  const least = Number(schema.minItems ?? 0);
  const most = Number(schema.maxItems ?? Infinity);
  if (isNumber(items) && least === most && least <= 4)
    return { ...common, type: "vector", items: Array.from({ length: least }, () => numberOf(items)) };
  if (isCurve(name) && items.type === "array" && items.minItems === 2) return { ...common, type: "curve" };
  const item = fieldOf(items, "");
  return { ...common, type: "list", item: item.type === "vector" ? { ...item, doc: common.doc } : item, least, most };
}

function unionOf(schema: Schema, name: string): Field {
  const options = schema.anyOf as Schema[];
  const common = commonOf(schema);
  if (isColor(options)) return { ...common, type: "color" };
  if (options.length === 2 && isKeys(options[1]!)) {
    const base = fieldOf({ ...options[0]!, description: schema.description, default: schema.default }, name);
    return { ...common, type: "keyed", base };
  }
  const object = options.find((o) => o.type === "object");
  if (object && options.length === 2 && options[0] !== object) {
    const fields = membersOf(object);
    // A rule or a point may be text or a list: those are typed as JSON. Else the plain value is the first member.
    if (options[0]!.type === "string" && !options[0]!.enum) return { ...common, type: "any" };
    if (options[0]!.type === "array") return { ...common, type: "any" };
    return { ...common, type: "object", fields, shorthand: [...fields.keys()][0] };
  }
  return { ...common, type: "any" };
}

function membersOf(schema: Schema): Map<string, Field> {
  const fields = new Map<string, Field>();
  for (const [name, inner] of Object.entries((schema.properties ?? {}) as Schema)) {
    if (isObject(inner)) fields.set(name, fieldOf(inner, name));
  }
  return fields;
}

export function fieldOf(schema: Schema, name: string): Field {
  if (schema.anyOf) return unionOf(schema, name);
  const common = commonOf(schema);
  if (schema.enum) {
    const options = optionsOf(schema, common.doc);
    const first = options.find((o) => o.doc);
    const doc = first ? common.doc.slice(0, common.doc.indexOf(`${first.value}: `)).replace(/[.;:\s]+$/, "") : common.doc;
    return { ...common, doc, type: "enum", options };
  }
  if (isNumber(schema)) return numberOf(schema, common);
  if (schema.type === "boolean") return { ...common, type: "boolean" };
  if (schema.type === "string") return { ...common, type: String(schema.pattern ?? "").startsWith("^#") ? "color" : "text" };
  if (schema.type === "array") return arrayOf(schema, name);
  if (schema.type === "object" && schema.properties) return { ...common, type: "object", fields: membersOf(schema) };
  if (schema.type === "object") return { ...common, type: "map" };
  return { ...common, type: "any" };
}

/** The schema of whole presets: its parts are read when they are first asked for. */
export class PresetSchema {
  private kindFields = new Map<string, ObjectField>();
  private parts = new Map<string, Field>();
  readonly kinds: EnumField["options"];
  /** Properties that `force` may name. */
  readonly forcible: Set<string>;

  constructor(private schema: Schema) {
    const kind = fieldOf((this.organism.properties as Schema).kind as Schema, "kind");
    this.kinds = kind.type === "enum" ? kind.options : [];
    const force = (this.schema.properties as Record<string, Schema>).force!;
    this.forcible = new Set((force.items as { enum?: string[] }).enum ?? []);
  }

  private get organism(): Schema {
    return (this.schema.properties as Record<string, Schema>).organisms!.items as Schema;
  }

  /** "film", "scene", "title" and the like. */
  part(name: string): Field {
    let found = this.parts.get(name);
    if (!found) this.parts.set(name, (found = fieldOf((this.schema.properties as Record<string, Schema>)[name] ?? {}, name)));
    return found;
  }

  /** What is said of a kind alone. */
  private ruleOf(name: string): { properties: Schema; leading?: string[] } | undefined {
    const rules = (this.organism.allOf ?? []) as { if: Schema; then: { properties: Schema; leading?: string[] } }[];
    return rules.find((r) => ((r.if.properties as Record<string, Schema>).kind as Schema).const === name)?.then;
  }

  /** The properties that shape a kind most, as paths, the most telling first. */
  leading(name: string): Path[] {
    return (this.ruleOf(name)?.leading ?? []).map((path) => path.split("/"));
  }

  /** All properties that organisms of a kind have. */
  kind(name: string): ObjectField {
    let found = this.kindFields.get(name);
    if (found) return found;
    const common = this.organism.properties as Schema;
    const rule = this.ruleOf(name);
    const properties = Object.fromEntries(
      Object.entries(rule?.properties ?? common).map(([key, inner]) => [key, inner === true ? common[key] : inner]),
    );
    found = { type: "object", doc: "", unit: "", fields: membersOf({ properties }) };
    this.kindFields.set(name, found);
    return found;
  }

  /** The field at a path of a preset whose organisms are of these kinds. */
  at(path: Path, kinds: string[]): Field | undefined {
    let [first, ...rest] = path;
    let field: Field | undefined;
    if (first === "organisms") field = rest.length ? this.kind(kinds[Number(rest.shift())] ?? "") : undefined;
    else if (first === "defaults") {
      const kind = [...kinds, ...this.kinds.map((k) => k.value)].find((k) => this.kind(k).fields.has(String(rest[0])));
      field = kind === undefined ? undefined : this.kind(kind);
    } else field = first === undefined ? undefined : this.part(String(first));
    for (const key of rest) {
      if (field?.type === "object") field = field.fields.get(String(key));
      else if (field?.type === "list") field = field.item;
      else return undefined;
    }
    return field;
  }
}

/** Names as a person reads them: "angle_jitter" is "angle jitter". */
export const spelled = (name: string): string => name.replaceAll("_", " ").replace(/^\$/, "");
