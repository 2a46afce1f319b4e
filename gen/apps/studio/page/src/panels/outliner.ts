/** What the preset is made of: itself, its scene, what counts for all, and its organisms, some of them in groups. */

import { el, grouped, iconButton } from "../dom";
import type { Selection } from "../drafts";
import { isWithin } from "../pointer";
import type { Store } from "../store";
import { openMenu } from "../controls/menu";
import { spelled } from "../schema";
import { calledBy } from "./species_panel";

const PARTS: [Selection, string, string[], string][] = [
  ["preset", "Preset and film", ["/title", "/seed", "/film", "/base"], "Title, seed, size and length"],
  ["scene", "Scene", ["/scene"], "Surroundings, camera, water, land"],
  ["all", "For all organisms", ["/defaults", "/force"], "Values of the scene that organisms share"],
];

/** A line of the outline. */
interface Line {
  label: string;
  detail: string;
  testid: string;
  /** The organisms that it stands for. */
  entries: number[];
  chosen: boolean;
  wrong: boolean;
  select(event: MouseEvent): void;
}

export function outliner(store: Store, addOrganism: () => void): HTMLElement {
  const parts = el("ul.outline", { "aria-label": "Parts of the preset" });
  const organisms = el("ul.outline", { "aria-label": "Organisms", "data-testid": "organisms" });
  const add = iconButton("add", "Add an organism", addOrganism, { "data-testid": "add-organism" });
  const element = el("section.outliner", { "aria-label": "Outline" }, parts, el("div.outline-head", {}, el("h2", {}, "Organisms"), add), organisms);
  /** Groups whose organisms are not listed. */
  const folded = new Set<string>();

  const hasFault = (pointers: string[]): boolean => store.faults.some((f) => pointers.some((p) => isWithin(f.pointer, p)));
  const line = ({ label, detail, testid, entries, chosen, wrong, select }: Line, ...tools: HTMLElement[]): HTMLElement => {
    const name = el("button.name", { type: "button", "aria-current": chosen ? "true" : null, "data-testid": testid, "data-entries": entries.join(" "), click: select },
      el("span.what", {}, label), detail && el("span.detail", {}, detail));
    return el(`li${chosen ? ".chosen" : ""}${wrong ? ".wrong" : ""}`, {}, name, ...tools);
  };

  /** All from the one that is selected to another. */
  const selectTo = (entry: number): void => {
    const from = typeof store.selected === "number" ? store.selected : entry;
    store.select(from);
    for (let i = Math.min(from, entry); i <= Math.max(from, entry); i++) if (i !== from) store.selectAlso(i);
  };

  /** Shows or hides organisms, and what else there is to do with them. */
  const tools = (name: string, id: string, entries: number[], meant: () => number[]): HTMLElement[] => {
    const [solo, hidden] = [entries.every((i) => store.solo.has(i)), entries.every((i) => store.hidden.has(i))];
    const group = store.preset.groupOf(entries[0]!);
    const more = iconButton("sliders", `${name}: copy, group, remove`, (event) =>
      openMenu(event.currentTarget as HTMLElement, [
        ...(entries.length === 1 ? [{ label: "Copy", act: () => store.copyOrganism(entries[0]!) }] : []),
        { label: "Group what is selected (Ctrl+G)", act: () => store.group(meant(), store.freeGroup()) },
        { label: "Take out of its group (Ctrl+Shift+G)", act: () => store.group(meant(), ""), disabled: !group },
        { label: "Remove", act: () => store.removeOrganisms(meant()) },
        { label: "Earlier (Alt+Up)", act: () => store.moveOrganisms(entries, -1) },
        { label: "Later (Alt+Down)", act: () => store.moveOrganisms(entries, 1) },
      ]), { "data-testid": `more:${id}`, "aria-haspopup": "menu" });
    return [
      iconButton("solo", `${name}: show it alone`, () => store.toggle("solo", meant(), !solo), { "aria-pressed": String(solo), "data-testid": `solo:${id}` }),
      iconButton(hidden ? "hidden" : "eye", `${name}: hide it`, () => store.toggle("hidden", meant(), !hidden), { "aria-pressed": String(hidden), "data-testid": `hide:${id}` }),
      more,
    ];
  };
  const isOff = (entry: number): boolean => store.hidden.has(entry) || (store.solo.size > 0 && !store.solo.has(entry));

  const organism = (entry: number): HTMLElement => {
    const name = store.preset.nameOf(entry);
    const drawn = store.scene.header?.entries[entry];
    const count = drawn ? drawn.specimens + drawn.copies : 0;
    const about = [spelled(store.preset.kindOf(entry)), calledBy(store.preset.speciesName(entry))].filter((word) => word && word !== name).join(", ");
    const item = line({
      label: name, detail: `${about}${count > 1 ? ` ×${grouped(count)}` : ""}`, testid: `organism:${entry}`, entries: [entry],
      chosen: store.chosen.includes(entry), wrong: hasFault([`/organisms/${entry}`]),
      select: (event) => {
        if (event.ctrlKey || event.metaKey) store.selectAlso(entry);
        else if (event.shiftKey) selectTo(entry);
        else store.select(entry);
      },
    }, ...tools(name, String(entry), [entry], () => store.meant(entry)));
    item.classList.toggle("off", isOff(entry));
    return item;
  };

  const fold = (group: string, shut: boolean): void => {
    if (shut) folded.add(group);
    else folded.delete(group);
    refresh();
  };
  const heading = (group: string): HTMLElement => {
    const entries = store.preset.inGroup(group);
    const shut = folded.has(group);
    const item = line({
      label: group, detail: `group of ${entries.length}`, testid: `group:${group}`, entries,
      chosen: entries.every((i) => store.chosen.includes(i)), wrong: shut && hasFault(entries.map((i) => `/organisms/${i}`)),
      select: () => store.selectAll(entries),
    }, ...tools(group, `group:${group}`, entries, () => entries));
    item.prepend(iconButton("open", `${group}: its organisms`, () => fold(group, !shut), { "aria-expanded": String(!shut), "data-testid": `fold:${group}` }));
    item.classList.add("heading");
    item.classList.toggle("off", entries.every(isOff));
    return item;
  };
  /** A group stands where the first of its organisms does. */
  const listed = (): HTMLElement[] =>
    [...store.preset.organisms.keys()].flatMap((i) => {
      const group = store.preset.groupOf(i);
      if (!group) return [organism(i)];
      const entries = store.preset.inGroup(group);
      if (entries[0] !== i) return [];
      const members = folded.has(group) ? [] : entries.map(organism);
      for (const one of members) one.classList.add("member");
      return [heading(group), ...members];
    });

  let shown = "";
  const refresh = (): void => {
    const state = JSON.stringify([store.selected, [...store.also], store.preset.organisms.map((_, i) => [store.preset.nameOf(i), store.preset.kindOf(i), store.preset.speciesName(i), store.preset.groupOf(i)]), [...store.solo], [...store.hidden], [...folded],
      store.scene.header?.entries.map((e) => e.specimens + e.copies), store.faults.map((f) => f.pointer)]);
    if (state === shown) return;
    shown = state;
    const focused = (document.activeElement as HTMLElement | null)?.dataset.testid;
    parts.replaceChildren(...PARTS.map(([selection, label, pointers, about]) => {
      const made = line({ label, detail: "", testid: `part:${selection}`, entries: [], chosen: store.selected === selection, wrong: hasFault(pointers), select: () => store.select(selection) });
      (made.firstElementChild as HTMLElement).dataset.tip = about;
      return made;
    }));
    organisms.replaceChildren(...listed());
    organisms.querySelector(".chosen")?.scrollIntoView({ block: "nearest" });
    if (focused && element.contains(document.activeElement) === false) element.querySelector<HTMLElement>(`[data-testid="${focused}"]`)?.focus();
  };
  element.addEventListener("keydown", (event) => keys(event, element, store, fold));
  store.on(["text", "selected", "shown", "scene", "opened"], refresh);
  return element;
}

const entriesOf = (name: HTMLElement | undefined): number[] => name?.dataset.entries?.split(" ").filter(Boolean).map(Number) ?? [];

/**
 * Up and down go from line to line, with Shift they select more, with Alt the organism or the group moves; right and left open
 * and fold a group; Ctrl+G makes one of what is selected, with Shift it takes it apart; Delete removes what is selected.
 */
function keys(event: KeyboardEvent, element: HTMLElement, store: Store, fold: (group: string, shut: boolean) => void): void {
  const names = [...element.querySelectorAll<HTMLElement>("button.name")];
  const at = names.indexOf(document.activeElement as HTMLElement);
  if (at < 0) return;
  const entries = entriesOf(names[at]);
  const isHeading = names[at]!.dataset.testid!.startsWith("group:");
  const group = isHeading ? store.preset.groupOf(entries[0]!) : "";
  const meant = isHeading || !entries.length ? entries : store.meant(entries[0]!);
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key] as 1 | -1 | undefined;
  const beside = step ? names[at + step] : undefined;
  const focus = (testid: string): void => element.querySelector<HTMLElement>(`[data-testid="${testid}"]`)?.focus();
  if (step && event.altKey && entries.length) {
    store.moveOrganisms(entries, step);
    focus(isHeading ? `group:${group}` : `organism:${String(store.selected)}`);
  } else if (step && event.shiftKey && !isHeading && entriesOf(beside).length === 1) {
    if (!store.chosen.includes(entries[0]!)) store.select(entries[0]!);
    store.selectAlso(entriesOf(beside)[0]!);
    focus(beside!.dataset.testid!);
  } else if (step) beside?.focus();
  else if (group && (event.key === "ArrowLeft" || event.key === "ArrowRight")) {
    fold(group, event.key === "ArrowLeft");
    focus(`group:${group}`);
  } else if (event.key.toLowerCase() === "g" && (event.ctrlKey || event.metaKey) && meant.length) store.group(meant, event.shiftKey ? "" : store.freeGroup());
  else if (event.key === "Delete" && entries.length) store.removeOrganisms(meant);
  else return;
  event.preventDefault();
}
