/** Lists: of colours, numbers, names and places side by side or in lines, of objects as groups that fold. */

import { el, iconButton } from "../dom";
import type { Field, ListField, PlainField } from "../schema";
import { spelled } from "../schema";
import { isObject } from "../pointer";
import { controlFor } from "./field";
import { fieldsOf, type Section } from "./group";
import { valueOf, type Control, type Place } from "./control";

/** An item to begin with. */
function fresh(field: Field, last: unknown): unknown {
  if (last !== undefined) return structuredClone(last);
  if (field.type === "vector") return field.items.map(() => 0);
  if (field.type === "color") return "#8fa36a";
  if (field.type === "number") return field.low > 0 ? field.low : 0;
  if (field.type === "object") return {};
  if (field.type === "list") return [];
  return "";
}

export function listControl(place: Place<ListField>, section?: Section): Control {
  const { field, binding, label } = place;
  const items = el("div.items");
  const add = iconButton("add", `Add to ${label}`, () => {
    const now = itemsOf();
    binding.set([...now, fresh(field.item, now.at(-1))]);
    items.lastElementChild?.querySelector<HTMLElement>("input, button, select")?.focus();
  });
  const element = el("div.list-control", {}, items, add);
  element.classList.add(field.item.type === "color" ? "inline" : "stacked");
  let built = -1;
  let inner: Control[] = [];

  const itemsOf = (): unknown[] => {
    const value = valueOf(place);
    return Array.isArray(value) ? value : [];
  };
  const remove = (index: number): void => {
    const { scope } = binding;
    if (scope === "unset") return binding.set(itemsOf().toSpliced(index, 1));
    binding.store.remove([...binding.path, index]);
  };

  const lineOf = (index: number): HTMLElement => {
    const name = `${label} ${index + 1}`;
    const child = binding.item(index);
    const drop = iconButton("close", `Remove ${name}`, () => remove(index));
    if (field.item.type === "object" && section) {
      const value = itemsOf()[index];
      const called = isObject(value) ? String(value.name ?? value.symbol ?? value.kind ?? value.shape ?? "") : "";
      const body = section.inner(`${binding.rel.join("/")}/${index}`, `${spelled(label)} ${index + 1}${called ? `, ${called}` : ""}`, field.item.doc, child, fieldsOf(field.item, child), drop);
      inner.push(body);
      return body.element;
    }
    const control = controlFor({ field: field.item, binding: child, label: name }, section);
    inner.push(control);
    return el("div.item", {}, control.element, drop);
  };

  return {
    element,
    wide: field.item.type !== "color",
    refresh(): void {
      const { length } = itemsOf();
      if (length !== built) {
        built = length;
        inner = [];
        items.replaceChildren(...Array.from({ length }, (_, i) => lineOf(i)));
        (add as HTMLButtonElement).disabled = length >= field.most;
      }
      for (const control of inner) control.refresh();
    },
  };
}

/** Names for numbers: members that the person names, each a number or an expression. */
export function mapControl(place: Place<PlainField>): Control {
  const { binding, label } = place;
  const rows = el("div.items");
  const name = el<HTMLInputElement>("input.text", { type: "text", placeholder: "name", "aria-label": `Name of a new one of ${label}` });
  const add = iconButton("add", `Add to ${label}`, () => {
    if (!name.value.trim()) return name.focus();
    binding.set({ ...valuesOf(), [name.value.trim()]: 1 });
    name.value = "";
  });
  let built = "";
  const valuesOf = (): Record<string, unknown> => {
    const value = valueOf(place);
    return isObject(value) ? value : {};
  };
  const row = (key: string): HTMLElement => {
    const box = el<HTMLInputElement>("input.text.code", { type: "text", "aria-label": `${label} ${key}`, value: String(valuesOf()[key]), spellcheck: false });
    box.addEventListener("change", () => {
      const number = Number(box.value);
      binding.set({ ...valuesOf(), [key]: box.value.trim() !== "" && Number.isFinite(number) ? number : box.value });
    });
    const drop = iconButton("close", `Remove ${key}`, () => binding.store.remove([...binding.path, key]));
    return el("div.item", {}, el("span.name", {}, key), box, drop);
  };
  return {
    element: el("div.list-control.stacked", {}, rows, el("div.item", {}, name, add)),
    wide: true,
    refresh(): void {
      const shape = JSON.stringify(valuesOf());
      if (shape === built || rows.contains(document.activeElement)) return;
      built = shape;
      rows.replaceChildren(...Object.keys(valuesOf()).map(row));
    },
  };
}
