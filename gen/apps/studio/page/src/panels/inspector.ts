/** The properties of what is selected. */

import * as api from "../api";
import { Binding } from "../controls/binding";
import type { Control } from "../controls/control";
import { fieldsOf, Section, type Member } from "../controls/group";
import { row, type Vary } from "../controls/row";
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
    const organism = typeof selected === "number" && !search.value;
    controls = organism ? [speciesControl(store, selected), ...ofOrganism(store, section, kind, members)] : section.members(members);
    title.textContent = typeof selected === "number" ? headOf(store, selected) : HEADS[selected];
    hint.textContent = hintOf(store, controls.length, search.value);
    const grammar = hasGrammar(store) && !search.value;
    const open = el("button.small.wide", { type: "button", "data-testid": "open-grammar", click: acts.openGrammar }, "Edit its grammar …");
    body.replaceChildren(...(grammar ? [open] : []), ...controls.map((c) => c.element));
    if (organism) body.append(el("p.hint", {}, el("a", { href: api.docs(`kinds/${kind}.md`), target: "_blank", rel: "noopener" }, `All of ${spelled(kind)}, with pictures`)));
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

/** Groups whose members are told for what they are by their own names. */
const PLAIN_GROUPS = new Set(["habit", "tree", "accretion", "crawl", "grammar", "swim", "colonize", "weathering"]);
/** What says which one of the list it is. */
const LISTED = ["name", "group", "count"];

const headed = (text: string): Control => ({ element: el("h3.part", {}, text), refresh: () => undefined });

/** What shapes it first, each with a picture where there is one; then the rest; what only lists it comes last. */
function ofOrganism(store: Store, section: Section, kind: string, members: Member[]): Control[] {
  const leading = store.schema.leading(kind).map((path) => memberAt(members, path)).filter((found) => found !== null);
  const lead = leading.map(({ path, member }): Control => {
    const [above, name] = [String(path.at(-2) ?? ""), String(path.at(-1))];
    const control = row(above && !PLAIN_GROUPS.has(above) ? `${above} ${name}` : name, member.field, member.binding, section, above ? "lead" : "row");
    const strip = `${kind}-${path.join("-")}`;
    if (store.strips.has(strip)) control.element.append(el("img.strip", { src: api.strip(strip), alt: `What ${spelled(name)} does: little, more, much`, loading: "lazy" }));
    return control;
  });
  const first = new Set(leading.filter(({ path }) => path.length === 1).map(({ member }) => member));
  const rest = members.filter((m) => !first.has(m) && !LISTED.includes(m.name));
  const last = members.filter((m) => LISTED.includes(m.name));
  return [...lead, ...(lead.length ? [headed("All else")] : []), ...section.members(rest), headed("In the list"), ...section.members(last)];
}

/** What stands at a path of properties. */
function memberAt(members: Member[], path: Path): { path: Path; member: Member } | null {
  let [list, member]: [Member[], Member | undefined] = [members, undefined];
  for (const key of path) {
    member = list.find((m) => m.name === key);
    if (!member) return null;
    list = member.field.type === "object" ? fieldsOf(member.field, member.binding) : [];
  }
  // A group is opened where it stands.
  return member && member.field.type !== "object" && !(member.field.type === "list" && member.field.item.type === "object") ? { path, member } : null;
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
