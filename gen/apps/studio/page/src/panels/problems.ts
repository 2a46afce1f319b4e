/** What is wrong, and what the preset says in vain, each with its place. */

import { el } from "../dom";
import type { Fault } from "../api";
import { fromPointer } from "../pointer";
import type { Store } from "../store";

export function problems(store: Store, acts: { goToLine(line: number, column: number): void; showControl(pointer: string): void }): { element: HTMLElement; count(): number } {
  const list = el("ul.problems", { "aria-label": "Problems", "data-testid": "problems" });
  const element = el("div.problems-panel", { tabIndex: 0, role: "region", "aria-label": "Problems and notes" }, list);

  const fault = (f: Fault): HTMLElement => {
    const line = f.line ? el("button.link", { type: "button", "data-tip": "Show it in the text", click: () => acts.goToLine(f.line, f.column) }, `line ${f.line}`) : el("span.link", {}, f.where);
    const pointer = f.pointer && el("button.link.code", { type: "button", "data-tip": "Show its control", click: () => acts.showControl(f.pointer) }, f.pointer);
    return el("li.wrong", {}, line, el("span", {}, f.text), pointer);
  };
  const note = (text: string): HTMLElement => {
    const pointer = /(\/(?:organisms|scene|film|defaults|force|seed|title)[^\s:,]*)/.exec(text)?.[1];
    return el("li.note", {}, el("span.link", {}, "note"), el("span", {}, text),
      pointer && el("button.link.code", { type: "button", click: () => acts.showControl(pointer) }, "show"));
  };
  const refresh = (): void => {
    const { trouble, notes } = store.scene;
    const items = [...(trouble ? [el("li.wrong", {}, el("span.link", {}, "server"), el("span", {}, trouble))] : []), ...store.faults.map(fault), ...notes.map(note)];
    list.replaceChildren(...(items.length ? items : [el("li.none", {}, "Nothing is wrong.")]));
  };
  store.on(["text", "scene", "opened"], refresh);
  refresh();
  return { element, count: () => store.faults.length + (store.scene.trouble ? 1 : 0) };
}

/** Selects what a pointer is in; answers the groups on the way to it. */
export function selectPointer(store: Store, pointer: string): string[] {
  const [first, ...rest] = fromPointer(pointer);
  let groups = rest;
  if (first === "organisms" && typeof rest[0] === "number") {
    store.select(rest[0]);
    groups = rest.slice(1);
  } else if (first === "defaults" && typeof store.selected === "number" && store.schema.kind(store.preset.kindOf(store.selected)).fields.has(String(rest[0]))) {
    groups = rest;
  } else if (first === "defaults") {
    store.select("all");
    groups = ["defaults", ...rest];
  } else if (first === "scene") {
    store.select("scene");
    groups = ["scene", ...rest];
  } else {
    store.select("preset");
    groups = [first ?? "", ...rest];
  }
  return groups.map((_, i) => groups.slice(0, i + 1).join("/"));
}
