/** A grammar as the page shows it: some properties in fields of their own, the others as JSON. */

import { packed, unpacked } from "./savings";

export interface Form {
  axiom: string;
  /** May be fractional. */
  steps: number;
  /** Degrees. */
  angle: number;
  seed: number;
  /** Rules, one a line; `limit 2: A -> B` is used twice at most. */
  rules: string;
  interpretation: string;
  decomposition: string;
  /** All other properties of a grammar, as members of a JSON object without its braces. */
  others: string;
}

export const LISTS = ["rules", "interpretation", "decomposition"] as const;
export type List = (typeof LISTS)[number];

export const EMPTY: Form = { axiom: "F", steps: 1, angle: 45, seed: 1, rules: "", interpretation: "", decomposition: "", others: "" };

type Rule = string | { rule: string; limit?: number };
type Json = Record<string, unknown>;

const toLine = (rule: Rule): string => (typeof rule === "string" ? rule : rule.limit === undefined ? rule.rule : `limit ${rule.limit}: ${rule.rule}`);

function fromLine(line: string): Rule {
  const limited = /^\s*limit\s+(\d+)\s*:\s*(.*)$/.exec(line);
  return limited ? { rule: limited[2]!, limit: Number(limited[1]) } : line;
}

/** The numbers of the lines, from 1, that hold a rule. */
const filled = (text: string): number[] => text.split("\n").flatMap((line, i) => (line.trim() ? [i + 1] : []));

/** A value on one line, with spaces as people write them. */
export function spaced(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(spaced).join(", ")}]`;
  if (value === null || typeof value !== "object") return JSON.stringify(value);
  return `{${Object.entries(value).map(([name, inner]) => `${JSON.stringify(name)}: ${spaced(inner)}`).join(", ")}}`;
}

/** The form of a grammar file. */
export function formOf(text: string): Form {
  const { axiom, steps, angle, seed, rules, interpretation, decomposition, ...others } = JSON.parse(text) as Json;
  const lines = (list: unknown): string => ((list as Rule[] | undefined) ?? []).map(toLine).join("\n");
  return {
    axiom: (axiom as string | undefined) ?? EMPTY.axiom,
    steps: (steps as number | undefined) ?? EMPTY.steps,
    angle: (angle as number | undefined) ?? EMPTY.angle,
    seed: (seed as number | undefined) ?? EMPTY.seed,
    rules: lines(rules),
    interpretation: lines(interpretation),
    decomposition: lines(decomposition),
    others: Object.entries(others).map(([name, value]) => `${JSON.stringify(name)}: ${spaced(value)}`).join(",\n"),
  };
}

/** The text of a grammar file. Only `others` begins on a line of its own, the second. */
export function textOf(form: Form): string {
  const { axiom, angle, seed } = form;
  const own: Json = { axiom, steps: Math.floor(form.steps), angle, seed };
  for (const list of LISTS) {
    const rules = form[list].split("\n").filter((line) => line.trim()).map(fromLine);
    if (rules.length) own[list] = rules;
  }
  const members = JSON.stringify(own).slice(0, -1);
  return form.others.trim() ? `${members},\n${form.others}\n}` : `${members}}`;
}

/** The same, laid out for people where it is correct JSON. */
export function fileOf(form: Form): string {
  const text = textOf(form);
  try {
    return `${JSON.stringify(JSON.parse(text), null, 2)}\n`;
  } catch {
    return `${text}\n`;
  }
}

/** Where a fault of the engine is: in which field and line. */
export interface Place {
  field: List | "axiom" | "others" | "";
  line: number;
  what: string;
}

export function placeOf(form: Form, where: string, what: string): Place {
  const rule = /\/(rules|interpretation|decomposition)\/(\d+)/.exec(where);
  if (rule) {
    const list = rule[1] as List;
    return { field: list, line: filled(form[list])[Number(rule[2])] ?? 1, what };
  }
  const line = Number(/^grammar:(\d+)/.exec(where)?.[1] ?? 1);
  if (line > 1) return { field: "others", line: Math.min(line - 1, form.others.split("\n").length), what };
  if (/\/axiom|^axiom/.test(where)) return { field: "axiom", line: 1, what };
  const property = where.replace(/^grammar:\d+:\d+: \//, "");
  return { field: "", line: 1, what: property ? `${property}: ${what}` : what };
}

/** The fragment of a link that carries a form. */
export const toFragment = (form: Form): string => packed(JSON.stringify(form));

/** Null where a fragment holds no form. */
export function fromFragment(fragment: string): Form | null {
  try {
    const read = JSON.parse(unpacked(fragment) ?? "") as Json;
    const alike = Object.entries(EMPTY).every(([name, value]) => typeof read[name] === typeof value);
    return alike ? (read as unknown as Form) : null;
  } catch {
    return null;
  }
}
