/** The properties that shape a coral most, each with its slider, list or colour, as the schema of presets describes them. */

import schema from "coral-schema";
import { hexOf } from "../../../gen/apps/studio/page/src/controls/color";
import { usualScale, valueAt } from "../../../gen/apps/studio/page/src/controls/scale";
import { el } from "../../../gen/apps/studio/page/src/dom";
import { getAt, type Path } from "../../../gen/apps/studio/page/src/pointer";
import { fieldOf, spelled, type EnumField, type Field, type NumberField } from "../../../gen/apps/studio/page/src/schema";

export const kinds = Object.keys(schema);

/** Colours that a kind has, of tissue or of the skin of branches. */
const COLORS = ["tissue/color", "tissue/second", "skin/tint/base", "skin/tint/secondary"];

const parts = new Map<string, Field>();
function fieldAt(kind: string, path: string): Field | undefined {
  const key = `${kind} ${path}`;
  if (!parts.has(key)) {
    let field: Field | undefined = fieldOf({ type: "object", properties: schema[kind]!.properties }, "");
    for (const name of path.split("/")) field = field?.type === "object" ? field.fields.get(name) : undefined;
    if (!field) return undefined;
    parts.set(key, field);
  }
  return parts.get(key);
}

const pathsOf = (kind: string): string[] => [...new Set([...schema[kind]!.leading, ...COLORS])].filter((path) => fieldAt(kind, path));

export interface Fields {
  element: HTMLElement;
  /** Shows an organism of a preset, but not in the field that is typed in. */
  show(kind: string, organism: unknown): void;
}

/** What people call a property: its last name, with the one before where that alone says little. */
function labelOf(path: string): string {
  const names = path.split("/"), last = names.at(-1)!;
  const named: Record<string, string> = { "tissue/color": "colour", "tissue/second": "in hollows", "skin/tint/base": "colour", "skin/tint/secondary": "in pores", "skin/kind": "skin", up: "height" };
  return named[path] ?? named[last] ?? spelled(last);
}

/** Rows of properties; `set` is told what is changed. */
export function coralFields(set: (path: Path, value: unknown) => void): Fields {
  const element = el("div.fields", { "data-testid": "coral-fields" });
  let shown = "", refreshers: ((organism: unknown) => void)[] = [];

  const row = (path: string, field: Field, ...controls: HTMLElement[]): HTMLElement =>
    el("div.row-of", { title: field.doc }, el("span", {}, labelOf(path)), ...controls);

  function numberRow(path: string, field: NumberField): HTMLElement {
    const label = labelOf(path), test = `coral-${path.replace(/\//g, "-")}`;
    const range = el<HTMLInputElement>("input.slider", { type: "range", min: "0", step: "1", "aria-label": label, "data-testid": `${test}-slider` });
    const number = el<HTMLInputElement>("input.number", { type: "number", step: "any", "aria-label": `${label}, as a number`, "data-testid": test });
    let scale = usualScale(field, NaN), given = NaN;
    range.addEventListener("input", () => {
      const value = valueAt(scale, field, range.valueAsNumber / scale.steps);
      number.value = String(value);
      set(path.split("/"), value);
    });
    number.addEventListener("input", () => Number.isFinite(number.valueAsNumber) && set(path.split("/"), number.valueAsNumber));
    refreshers.push((organism) => {
      const value = Number(getAt(organism, path.split("/")) ?? field.default);
      if (!Number.isFinite(value)) return;
      // The slider keeps its range while it is drawn.
      if (document.activeElement !== range && value !== given) scale = usualScale(field, value);
      given = value;
      range.max = String(scale.steps);
      range.value = String(Math.round(scale.toWay(value) * scale.steps));
      if (document.activeElement !== number) number.value = String(value);
    });
    return row(path, field, range, number, el("span.unit", {}, field.unit));
  }

  function choiceRow(path: string, field: EnumField): HTMLElement {
    const list = el<HTMLSelectElement>("select", { "aria-label": labelOf(path), "data-testid": `coral-${path.replace(/\//g, "-")}` },
      ...field.options.filter(({ value }) => value !== "own").map(({ value, doc }) => el("option", { value, title: doc }, spelled(value))));
    list.addEventListener("change", () => set(path.split("/"), list.value));
    refreshers.push((organism) => (list.value = String(getAt(organism, path.split("/")) ?? field.default)));
    return row(path, field, list);
  }

  function colorRow(path: string, field: Field): HTMLElement {
    const label = labelOf(path), test = `coral-${path.replace(/\//g, "-")}`;
    const swatch = el<HTMLInputElement>("input.swatch", { type: "color", "aria-label": label, "data-testid": test });
    const text = el("span.code", {});
    swatch.addEventListener("input", () => set(path.split("/"), swatch.value));
    refreshers.push((organism) => {
      const hex = hexOf(getAt(organism, path.split("/")) ?? field.default, undefined) ?? "#000000";
      swatch.value = text.textContent = hex;
    });
    return row(path, field, swatch, text);
  }

  function build(kind: string): void {
    refreshers = [];
    element.replaceChildren(...pathsOf(kind).map((path) => {
      const field = fieldAt(kind, path)!;
      if (field.type === "number") return numberRow(path, field);
      if (field.type === "enum") return choiceRow(path, field);
      return colorRow(path, field);
    }));
  }
  return {
    element,
    show: (kind, organism) => {
      if (kind !== shown) build(kind);
      shown = kind;
      refreshers.forEach((refresh) => refresh(organism));
    },
  };
}
