/** What the preset is made of: itself, its scene, what counts for all, and its organisms. */

import { el, iconButton } from "../dom";
import type { Selection } from "../drafts";
import { isWithin } from "../pointer";
import type { Store } from "../store";
import { grouped } from "../dom";
import { openMenu } from "../controls/menu";
import { spelled } from "../schema";
import { calledBy } from "./species_panel";

const PARTS: [Selection, string, string[], string][] = [
  ["preset", "Preset and film", ["/title", "/seed", "/film", "/base"], "Title, seed, size and length"],
  ["scene", "Scene", ["/scene"], "Surroundings, camera, water, land"],
  ["all", "For all organisms", ["/defaults", "/force"], "Values of the scene that organisms share"],
];

export function outliner(store: Store, addOrganism: () => void): HTMLElement {
  const parts = el("ul.outline", { "aria-label": "Parts of the preset" });
  const organisms = el("ul.outline", { "aria-label": "Organisms", "data-testid": "organisms" });
  const add = iconButton("add", "Add an organism", addOrganism, { "data-testid": "add-organism" });
  const element = el("section.outliner", { "aria-label": "Outline" }, parts, el("div.outline-head", {}, el("h2", {}, "Organisms"), add), organisms);

  const hasFault = (pointers: string[]): boolean => store.faults.some((f) => pointers.some((p) => isWithin(f.pointer, p)));
  const line = (selection: Selection, label: string, detail: string, wrong: boolean, testid: string, ...tools: HTMLElement[]): HTMLElement => {
    const chosen = store.selected === selection || (typeof selection === "number" && store.also.has(selection));
    const select = (event: MouseEvent): void => {
      if (typeof selection !== "number") store.select(selection);
      else if (event.ctrlKey || event.metaKey) store.selectAlso(selection);
      else if (event.shiftKey) selectTo(selection);
      else store.select(selection);
    };
    const name = el("button.name", { type: "button", "aria-current": chosen ? "true" : null, "data-testid": testid, click: select },
      el("span.what", {}, label), detail && el("span.detail", {}, detail));
    return el(`li${chosen ? ".chosen" : ""}${wrong ? ".wrong" : ""}`, {}, name, ...tools);
  };

  /** All from the one that is selected to another. */
  const selectTo = (entry: number): void => {
    const from = typeof store.selected === "number" ? store.selected : entry;
    store.select(from);
    for (let i = Math.min(from, entry); i <= Math.max(from, entry); i++) if (i !== from) store.selectAlso(i);
  };

  const organism = (entry: number): HTMLElement => {
    const name = store.preset.nameOf(entry);
    const drawn = store.scene.header?.entries[entry];
    const count = drawn ? drawn.specimens + drawn.copies : 0;
    const off = store.hidden.has(entry) || (store.solo.size > 0 && !store.solo.has(entry));
    const more = iconButton("sliders", `${name}: copy, remove`, (event) =>
      openMenu(event.currentTarget as HTMLElement, [
        { label: "Copy", act: () => store.copyOrganism(entry) },
        { label: "Remove", act: () => store.removeOrganisms(store.meant(entry)) },
        { label: "Earlier (Alt+Up)", act: () => store.moveOrganism(entry, -1), disabled: entry === 0 },
        { label: "Later (Alt+Down)", act: () => store.moveOrganism(entry, 1), disabled: entry === store.preset.organisms.length - 1 },
      ]), { "data-testid": `more:${entry}`, "aria-haspopup": "menu" });
    const about = [spelled(store.preset.kindOf(entry)), calledBy(store.preset.speciesName(entry))].filter((word) => word && word !== name).join(", ");
    const item = line(entry, name, `${about}${count > 1 ? ` ×${grouped(count)}` : ""}`, hasFault([`/organisms/${entry}`]), `organism:${entry}`,
      iconButton("solo", `${name}: show it alone`, () => store.toggle("solo", store.meant(entry), !store.solo.has(entry)), { "aria-pressed": String(store.solo.has(entry)), "data-testid": `solo:${entry}` }),
      iconButton(store.hidden.has(entry) ? "hidden" : "eye", `${name}: hide it`, () => store.toggle("hidden", store.meant(entry), !store.hidden.has(entry)), { "aria-pressed": String(store.hidden.has(entry)), "data-testid": `hide:${entry}` }),
      more);
    item.classList.toggle("off", off);
    return item;
  };

  let shown = "";
  const refresh = (): void => {
    const state = JSON.stringify([store.selected, [...store.also], store.preset.organisms.map((_, i) => [store.preset.nameOf(i), store.preset.kindOf(i), store.preset.speciesName(i)]), [...store.solo], [...store.hidden],
      store.scene.header?.entries.map((e) => e.specimens + e.copies), store.faults.map((f) => f.pointer)]);
    if (state === shown) return;
    shown = state;
    const focused = (document.activeElement as HTMLElement | null)?.dataset.testid;
    parts.replaceChildren(...PARTS.map(([selection, label, pointers, about]) => {
      const made = line(selection, label, "", hasFault(pointers), `part:${selection}`);
      (made.firstElementChild as HTMLElement).dataset.tip = about;
      return made;
    }));
    organisms.replaceChildren(...store.preset.organisms.map((_, i) => organism(i)));
    organisms.querySelector(".chosen")?.scrollIntoView({ block: "nearest" });
    if (focused && element.contains(document.activeElement) === false) element.querySelector<HTMLElement>(`[data-testid="${focused}"]`)?.focus();
  };
  element.addEventListener("keydown", (event) => keys(event, element, store));
  store.on(["text", "selected", "shown", "scene", "opened"], refresh);
  return element;
}

/** Up and down go from line to line, with Shift they select more, with Alt the organism moves; Delete removes what is selected. */
function keys(event: KeyboardEvent, element: HTMLElement, store: Store): void {
  const names = [...element.querySelectorAll<HTMLElement>("button.name")];
  const at = names.indexOf(document.activeElement as HTMLElement);
  if (at < 0) return;
  const entry = at - PARTS.length;
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key] as 1 | -1 | undefined;
  if (step && event.altKey && entry >= 0) {
    store.moveOrganism(entry, step);
    element.querySelector<HTMLElement>(`[data-testid="organism:${String(store.selected)}"]`)?.focus();
  } else if (step && event.shiftKey && entry >= 0 && entry + step >= 0 && names[at + step]) {
    if (!store.chosen.includes(entry)) store.select(entry);
    store.selectAlso(entry + step);
    element.querySelector<HTMLElement>(`[data-testid="organism:${entry + step}"]`)?.focus();
  } else if (step) names[at + step]?.focus();
  else if (event.key === "Delete" && entry >= 0) store.removeOrganisms(store.meant(entry));
  else return;
  event.preventDefault();
}
