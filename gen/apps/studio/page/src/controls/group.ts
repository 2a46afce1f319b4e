/** Groups of properties that fold. What is in one is built when it is first opened. */

import { el, icon } from "../dom";
import { countsBesideFile } from "../grammar_file";
import { isWithin, toPointer, type Path } from "../pointer";
import { spelled, type Field, type ObjectField } from "../schema";
import type { Store } from "../store";
import type { Binding } from "./binding";
import type { Control } from "./control";
import { row, type Vary } from "./row";

export interface Member {
  name: string;
  field: Field;
  binding: Binding;
}

export const fieldsOf = (field: ObjectField, binding: Binding): Member[] =>
  [...field.fields].map(([name, inner]) => ({ name, field: inner, binding: binding.member(name, field.shorthand) }));

/** What groups have in common: which are open, what is searched for. */
export class Section {
  private static open = new Set<string>();

  constructor(
    readonly store: Store,
    /** Groups of the same name fold alike in all of a kind. */
    private name: string,
    readonly vary: Vary,
    readonly showInText: (path: Path) => void,
    private search = "",
  ) {}

  /** Rows and groups of members; those that the search does not find are left out. */
  members(list: Member[]): Control[] {
    const rows = list.filter((m) => !this.isGroup(m.field) && this.finds(m));
    const groups = list.filter((m) => this.isGroup(m.field) && this.finds(m));
    return [...rows.map((m) => row(m.name, m.field, m.binding, this)), ...groups.map((m) => this.group(m))];
  }

  private isGroup(field: Field): boolean {
    return field.type === "object" || (field.type === "list" && field.item.type === "object");
  }

  private finds({ name, field }: Member): boolean {
    if (!this.search) return true;
    const words = `${spelled(name)} ${field.doc}`.toLowerCase();
    if (this.search.split(/\s+/).every((word) => words.includes(word))) return true;
    const inner = field.type === "list" ? field.item : field;
    return inner.type === "object" && [...inner.fields].some(([n, f]) => this.finds({ name: n, field: f } as Member));
  }

  private group({ name, field, binding }: Member): Control {
    const key = binding.rel.join("/");
    if (field.type === "object") {
      const found = this.search && spelled(name).includes(this.search) ? this.unsearched() : this;
      return found.inner(key, spelled(name), field.doc, binding, this.counting(fieldsOf(field, binding)));
    }
    const lines = [{ name, field, binding }];
    return this.fold(key, spelled(name), field.doc, binding, () => lines.map((m) => row(m.name, m.field, m.binding, this)));
  }

  /** Those that do something, and those that are set, so that they can be taken out. */
  private counting(list: Member[]): Member[] {
    return list.filter(({ binding }) => binding.entry === null || binding.get() !== undefined || countsBesideFile(this.store, binding.entry, binding.rel));
  }

  private unsearched(): Section {
    const all = new Section(this.store, this.name, this.vary, this.showInText);
    all.unfolded = true;
    return all;
  }
  private unfolded = false;

  inner(key: string, title: string, doc: string, binding: Binding, list: Member[], ...tools: HTMLElement[]): Control {
    return this.fold(key, title, doc, binding, () => this.members(list), ...tools);
  }

  private fold(key: string, title: string, doc: string, binding: Binding, build: () => Control[], ...tools: HTMLElement[]): Control {
    const id = `${this.name}:${key}`;
    const body = el("div.group-body");
    const head = el<HTMLButtonElement>("button.group-head", { type: "button", "data-tip": doc || null, "data-testid": `group:${key}` }, icon("open"), el("span", {}, title));
    const element = el("section.group", { "aria-label": title }, tools.length ? el("div.group-line", {}, head, ...tools) : head, body);
    let inner: Control[] | null = null;

    const show = (open: boolean): void => {
      head.setAttribute("aria-expanded", String(open));
      element.classList.toggle("open", open);
      if (open && !inner) {
        inner = build();
        body.replaceChildren(...inner.map((c) => c.element));
      }
      if (open) inner?.forEach((c) => c.refresh());
    };
    head.addEventListener("click", () => {
      const open = head.getAttribute("aria-expanded") !== "true";
      if (open) Section.open.add(id);
      else Section.open.delete(id);
      show(open);
    });
    show(Section.open.has(id) || this.search !== "" || this.unfolded);

    return {
      element,
      refresh: (): void => {
        element.classList.toggle("set", binding.get() !== undefined);
        element.classList.toggle("wrong", this.hasFault(binding));
        if (head.getAttribute("aria-expanded") === "true") inner?.forEach((c) => c.refresh());
      },
    };
  }

  private hasFault({ entry, rel }: Binding): boolean {
    const places = entry === null ? [rel] : [["organisms", entry, ...rel], ["defaults", ...rel]];
    return this.store.faults.some((f) => f.pointer && places.some((p) => isWithin(f.pointer, toPointer(p))));
  }

  static openGroup(name: string, key: string): void {
    Section.open.add(`${name}:${key}`);
  }
}
