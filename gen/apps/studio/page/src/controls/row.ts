/** A property: its label, its control, and whose value it has. */

import { el, icon } from "../dom";
import { isWithin, toPointer } from "../pointer";
import { spelled, type Field } from "../schema";
import type { Binding } from "./binding";
import type { Control } from "./control";
import { controlFor } from "./field";
import type { Section } from "./group";
import { openMenu, type MenuItem } from "./menu";

/** What the page does with a slider's range: the wall of variations is told of it. */
export type Vary = (binding: Binding, field: Field) => void;

/** `place`: what stands before its path where tests look for it; of one that is shown twice, another. */
export function row(name: string, field: Field, binding: Binding, section: Section, place = "row"): Control {
  const control = controlFor({ field, binding, label: spelled(name) }, section);
  const isProperty = binding.entry !== null && binding.property === binding.rel && name !== "name";
  const dot = el("button.dot", { type: "button", tabIndex: -1, "aria-label": `${spelled(name)}: back to the default`, click: () => binding.reset() });
  const label = el<HTMLButtonElement>("button.label", { type: "button", "aria-haspopup": "menu", "data-tip": tipOf(name, field), click: () => openMenu(label, actions()) }, spelled(name));
  const scope = isProperty ? el<HTMLButtonElement>("button.scope", { type: "button", "data-testid": `scope:${binding.rel.join("/")}` }) : null;
  const fault = el("p.fault");
  const element = el(
    "div.row",
    { "data-testid": `${place}:${binding.entry === null ? "" : "organism/"}${binding.rel.join("/")}` },
    dot,
    label,
    el("div.control", {}, control.element),
    scope,
    fault,
  );
  if (control.wide) element.classList.add("wide");
  // What is typed and cannot be read is told of here.
  let misread = "";
  element.addEventListener("misread", (event) => {
    misread = (event as CustomEvent<string>).detail;
    event.stopPropagation();
    tellFaults();
  });

  const actions = (): MenuItem[] => {
    const told = binding.inSpecies;
    const items: MenuItem[] = [{ label: told ? "Back to its species" : "Back to the default", act: () => binding.reset(), disabled: !binding.canReset }];
    if (isProperty) {
      const { scope } = binding;
      items.push({ label: "A value of its own", checked: scope === "own" || scope === "unset", act: () => binding.useOwn(field.default) });
      if (told) items.push({ label: "The value of its species", checked: scope === "species", act: () => binding.reset(), disabled: !binding.canReset });
      else items.push({ label: "One value for all", checked: scope === "all" && !binding.forced, act: () => useForAll() });
      if (section.store.schema.forcible.has(binding.rel.join("/"))) items.push({ label: "Force it for all", checked: binding.forced, act: () => binding.toggleForce() });
    }
    if (field.type === "number" || (field.type === "keyed" && field.base.type === "number"))
      items.push({ label: "Nine variations of it …", act: () => section.vary(binding, field) });
    items.push({ label: "Show it in the text", act: () => section.showInText(binding.path) });
    return items;
  };
  const useForAll = (): void => {
    if (binding.forced) binding.toggleForce();
    if (binding.scope !== "all") binding.useForAll(field.default);
  };
  scope?.addEventListener("click", () => {
    if (binding.scope === "all" || binding.scope === "species") binding.useOwn(field.default);
    else if (binding.inSpecies) binding.reset();
    else useForAll();
  });

  const refresh = (): void => {
    control.refresh();
    const now = binding.scope;
    dot.classList.toggle("set", now !== "unset");
    dot.classList.toggle("all", now === "all" || now === "species");
    dot.toggleAttribute("disabled", !binding.canReset);
    if (scope) showScope(scope, binding, spelled(name));
    tellFaults();
  };
  const tellFaults = (): void => {
    const pointer = binding.pointer;
    const said = section.store.faults.filter((f) => f.pointer && isWithin(f.pointer, pointer) && !isInGroup(f.pointer)).map((f) => f.text);
    if (misread) said.unshift(misread);
    element.classList.toggle("wrong", said.length > 0);
    fault.textContent = said.join("; ");
  };
  /** Faults in objects of a list stand at their own rows. */
  const isInGroup = (pointer: string): boolean =>
    field.type === "list" && field.item.type === "object" && pointer.slice(toPointer(binding.path).length).split("/").length > 2;
  return { element, refresh };
}

function tipOf(name: string, field: Field): string {
  const unit = field.unit ? ` (${field.unit})` : "";
  const range = field.type === "number" && Number.isFinite(field.high) ? ` From ${field.low} to ${field.high}.` : "";
  const plain = field.default !== undefined && typeof field.default !== "object" ? ` Default ${String(field.default)}.` : "";
  return `${field.doc || spelled(name)}${unit}.${range}${plain}`.replace("..", ".");
}

function showScope(button: HTMLButtonElement, binding: Binding, name: string): void {
  const now = binding.scope;
  const text = binding.forced ? "forced" : now === "unset" ? "own" : now;
  if (button.dataset.now === `${now} ${text}`) return;
  button.dataset.now = `${now} ${text}`;
  button.className = `scope ${now} ${text}`;
  button.replaceChildren(...(binding.forced ? [icon("lock"), "all"] : [text === "species" ? "sp." : text]));
  const [spoken, tip] = SCOPES[text];
  button.setAttribute("aria-label", `${name}: ${spoken}`);
  button.dataset.tip = tip;
}

const SCOPES = {
  own: ["own value", "Its own value. Press for the one that it would have otherwise."],
  species: ["value of its species", "The value of its species. Change it, or press, and it has its own."],
  all: ["one value for all", "One value for all organisms. Press for its own."],
  forced: ["forced for all", "One value for all organisms, whatever they say themselves. Press for its own."],
} as const;
