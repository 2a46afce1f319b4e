/** The properties of what is selected. */

import { Binding } from "../controls/binding";
import type { Control } from "../controls/control";
import { fieldsOf, Section, type Member } from "../controls/group";
import type { Vary } from "../controls/row";
import { el, icon, quiet } from "../dom";
import { grammarFileOf } from "../grammar_file";
import type { Path } from "../pointer";
import type { Store } from "../store";
import { spelled } from "../schema";
import { speciesControl } from "./species_panel";

export interface InspectorActs {
  vary: Vary;
  showInText(path: Path): void;
  openGrammar(): void;
}

export function inspector(store: Store, acts: InspectorActs): HTMLElement {
  const search = el<HTMLInputElement>("input.text", { type: "search", placeholder: "Filter properties", "aria-label": "Filter properties", "data-testid": "search", autocomplete: "off" });
  const title = el("h2");
  const hint = el("p.hint");
  const body = el("div.properties", { tabIndex: -1 });
  const element = el("section.inspector", { "aria-label": "Properties" },
    el("div.inspector-head", {}, title, el("span.search", {}, icon("search"), search)), hint, body);
  let controls: Control[] = [];
  let built = "";

  const build = (): void => {
    const { selected } = store;
    const kind = typeof selected === "number" ? store.preset.kindOf(selected) : selected;
    const section = new Section(store, kind, acts.vary, acts.showInText, search.value.trim().toLowerCase());
    const members = membersOf(store);
    const species = typeof selected === "number" && !search.value ? [speciesControl(store, selected)] : [];
    controls = [...species, ...section.members(members)];
    title.textContent = typeof selected === "number" ? headOf(store, selected) : HEADS[selected];
    hint.textContent = hintOf(store, controls.length, search.value);
    const grammar = hasGrammar(store) && !search.value;
    const open = el("button.small.wide", { type: "button", "data-testid": "open-grammar", click: acts.openGrammar }, "Edit its grammar …");
    body.replaceChildren(...(grammar ? [open] : []), ...controls.map((c) => c.element));
    refresh();
  };
  const refresh = (): void => controls.forEach((c) => c.refresh());
  const update = (): void => {
    const { selected, preset } = store;
    const shape = typeof selected === "number" ? `${selected} ${preset.kindOf(selected)} ${grammarFileOf(store, selected) !== null}` : `${selected} ${selected === "all" ? [...new Set(store.kinds)].join() : selected === "scene" ? settingOf(store) : ""}`;
    if (shape === built) {
      if (typeof selected === "number") title.textContent = headOf(store, selected);
      return refresh();
    }
    built = shape;
    body.scrollTop = 0;
    build();
  };

  const filter = quiet(120, build);
  search.addEventListener("input", filter);
  search.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !search.value) return;
    search.value = "";
    build();
    event.stopPropagation();
  });
  store.on("opened-groups", () => {
    search.value = "";
    build();
  });
  let errors = "";
  store.on(["text", "selected", "opened"], update);
  store.on("scene", () => {
    const now = JSON.stringify(store.faults);
    if (now !== errors) refresh();
    errors = now;
  });
  return element;
}

/** Its name, and what it is where that does not say it. */
const headOf = (store: Store, entry: number): string => {
  const { preset } = store;
  const kind = spelled(preset.kindOf(entry));
  const name = preset.nameOf(entry);
  return name === kind || !kind ? name : `${name}, ${kind}`;
};

const HEADS = { preset: "Preset and film", scene: "Scene", all: "For all organisms" };

function hintOf(store: Store, found: number, search: string): string {
  if (!found && search) return `Nothing here is called “${search}”.`;
  if (store.selected === "all" && !store.kinds.length) return "Add an organism first.";
  if (store.selected === "all") return "An organism's own value wins, unless it is forced for all.";
  return "";
}

/** What the properties of the selection are, and where they stand. */
function membersOf(store: Store): Member[] {
  const { selected, schema } = store;
  if (selected === "preset") {
    const film = new Binding(store, null, ["film"]);
    const plain = ["title", "seed", "base"].map((name) => ({ name, field: schema.part(name), binding: new Binding(store, null, [name]) }));
    const part = schema.part("film");
    return [...plain, ...(part.type === "object" ? fieldsOf(part, film) : [])];
  }
  if (selected === "scene") {
    const part = schema.part("scene");
    return part.type === "object" ? sceneMembers(store, fieldsOf(part, new Binding(store, null, ["scene"]))) : [];
  }
  if (selected === "all") return sharedMembers(store);
  const kind = store.preset.kindOf(selected);
  const list = fieldsOf(schema.kind(kind), new Binding(store, selected, []));
  // Its kind is shown at its name; another kind would be another organism. The species stands above all.
  return list.filter((m) => m.name !== "kind" && m.name !== "species");
}

/** What the chosen setting reads, and what the preset says in vain, so that it can be taken out. */
function sceneMembers(store: Store, all: Member[]): Member[] {
  const setting = all.find((m) => m.name === "setting");
  const chosen = settingOf(store);
  if (setting?.field.type !== "enum") return all;
  const names = new Set(setting.field.options.map((o) => o.value));
  // "Hour and land, for forest; clouds and haze are the meadow's" names whom a group is for and whose it takes as well.
  const takes = new Set([chosen, ...[...(all.find((m) => m.name === chosen)?.field.doc ?? "").matchAll(/the (\w+)'s/g)].map((found) => found[1]!)]);
  const isFor = (m: Member): boolean => {
    const listed = (/\bfor ([\w, ]+)/.exec(m.field.doc)?.[1] ?? "").split(/,? and |, /).filter((word) => names.has(word));
    return !listed.length || listed.some((word) => takes.has(word) && (word === chosen || m.name === word));
  };
  return all.filter((m) => isFor(m) || m.binding.get() !== undefined);
}

const settingOf = (store: Store): string => {
  const value = new Binding(store, null, ["scene", "setting"]).get();
  const part = store.schema.part("scene");
  return String(value ?? (part.type === "object" ? part.fields.get("setting")?.default : "") ?? "");
};

/** Properties of all kinds that stand in the scene. */
function sharedMembers(store: Store): Member[] {
  const found = new Map<string, Member>();
  for (const kind of new Set(store.kinds)) {
    for (const [name, field] of store.schema.kind(kind).fields) {
      if (name === "kind" || name === "name" || found.has(name)) continue;
      found.set(name, { name, field, binding: new Binding(store, null, ["defaults", name]) });
    }
  }
  return [...found.values()].sort((a, b) => spelled(a.name).localeCompare(spelled(b.name)));
}

/** Does the selection grow by rules that can be typed? */
function hasGrammar(store: Store): boolean {
  const { selected } = store;
  if (typeof selected !== "number") return false;
  const { form, grammar } = store.preset.organism(selected);
  return grammar !== undefined || form === "own" || store.preset.kindOf(selected) === "plant";
}
