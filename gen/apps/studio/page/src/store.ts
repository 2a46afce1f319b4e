/** The state of the page. Panels read it, change it by its methods, and listen to what has changed. */

import type { Doc, Fault, Listed, Loaded, Start } from "./api";
import { quiet } from "./dom";
import { loadDraft, saveDraft, type Selection } from "./drafts";
import { insertAt, removeAt, setAt, sliceAt } from "./edits";
import { getAt, type Path } from "./pointer";
import { beside, Preset } from "./preset";
import { readSpecies, readWithBases } from "./species";
import { PresetSchema } from "./schema";
import { NO_SCENE, type SceneStatus } from "./scene_status";

export type Change =
  | "text" // the preset's text, and so all values
  | "opened" // another preset
  | "selected"
  | "time"
  | "shown" // which organisms are drawn
  | "scene" // a picture of the model came, or what kept it from coming
  | "saved"
  | "opened-groups" // groups of properties are to be open that were not
  | "link"; // the server came or went

const UNDO_STEPS = 200;

export class Store {
  schema!: PresetSchema;
  symbols: Start["symbols"] = [];
  presets: Listed[] = [];
  /** The properties of which there are pictures, as "tree-habit-droop". */
  strips = new Set<string>();
  /** Whether films can be handed to Slurm. */
  farm = false;
  /** Where presets are written: that of the preset the studio was opened with, else where it was started. */
  folder = "";

  file = "";
  disk: string | null = null;
  copy = true;
  saved = "";
  preset = new Preset("{}");
  isOpen = false;

  selected: Selection = "preset";
  /** Further organisms that are selected beside that one: what is done is done with all of them. */
  also: ReadonlySet<number> = new Set();
  /** Whether a person chose what is selected: what a preset opens with is not marked in the view. */
  picked = false;
  time = 0;
  /** An organism that was added and not looked at yet. */
  added: number | null = null;
  solo = new Set<number>();
  hidden = new Set<number>();
  scene: SceneStatus = { ...NO_SCENE };
  link: "up" | "down" | "refused" = "up";

  private undoTexts: string[] = [];
  private redoTexts: string[] = [];
  private gesture = "";
  private base: Record<string, unknown> = {};
  private baseName = "";
  /** By their files; null: not there yet, or none. */
  private species = new Map<string, Record<string, unknown> | null>();
  private listeners = new Map<Change, Set<() => void>>();
  private keep = quiet(250, () => this.keepDraft());

  on(change: Change | Change[], act: () => void): () => void {
    const changes = Array.isArray(change) ? change : [change];
    for (const c of changes) (this.listeners.get(c) ?? this.listeners.set(c, new Set()).get(c)!).add(act);
    return () => changes.forEach((c) => this.listeners.get(c)?.delete(act));
  }

  emit(change: Change): void {
    for (const act of [...(this.listeners.get(change) ?? [])]) act();
  }

  begin(start: Start): void {
    this.schema = new PresetSchema(start.schema);
    this.symbols = start.symbols;
    this.presets = start.presets;
    this.strips = new Set(start.strips);
    this.farm = start.machine.farm;
    this.folder = start.preset ? start.preset.file.replace(/[^/]*$/, "") : "";
  }

  // The document

  get text(): string {
    return this.preset.text;
  }
  get doc(): Doc {
    return { text: this.text, file: this.file };
  }
  /** The file's name without its folders. */
  get name(): string {
    return this.file.split("/").at(-1)!;
  }
  get unsaved(): boolean {
    return this.isOpen && this.text !== this.saved;
  }
  get kinds(): string[] {
    return this.preset.organisms.map((_, i) => this.preset.kindOf(i));
  }

  /** Opens what was loaded; a shipped one as a copy, which has no file yet. */
  open(loaded: Loaded): void {
    this.file = loaded.file;
    this.disk = loaded.disk;
    this.copy = loaded.copy ?? false;
    this.saved = loaded.text;
    this.undoTexts = [];
    this.redoTexts = [];
    this.show(loaded.text);
    this.time = this.preset.end;
    this.selected = this.preset.organisms.length ? this.preset.subject : "scene";
    this.announceOpened();
  }

  /** Goes on where a reload interrupted; false where there was nothing. */
  restore(draft = loadDraft()): boolean {
    if (!draft) return false;
    this.file = draft.file;
    this.disk = draft.disk;
    this.copy = draft.copy;
    this.saved = draft.saved;
    this.undoTexts = draft.undo;
    this.redoTexts = draft.redo;
    this.show(draft.text);
    this.time = draft.time;
    this.selected = draft.selected;
    this.announceOpened();
    return true;
  }

  close(): void {
    this.isOpen = false;
    saveDraft(null);
    this.emit("opened");
  }

  private announceOpened(): void {
    this.isOpen = true;
    this.picked = false;
    this.also = new Set();
    this.added = null;
    this.solo.clear();
    this.hidden.clear();
    this.scene = { ...NO_SCENE };
    this.keepRight();
    this.keepDraft();
    this.emit("opened");
    this.emit("text");
    this.emit("selected");
    this.emit("scene");
    this.emit("saved");
  }

  markSaved(file: string, disk: string, text: string): void {
    this.file = file;
    this.disk = disk;
    this.copy = false;
    this.saved = text;
    this.keep();
    this.emit("saved");
  }

  private made(text: string): Preset {
    return new Preset(text, this.base, (name) => this.species.get(beside(this.file, name)) ?? undefined);
  }

  private show(text: string): void {
    this.preset = this.made(text);
    this.learnSpecies();
    const base = typeof this.preset.own.base === "string" ? this.preset.own.base : "";
    const name = base && beside(this.file, base);
    if (name === this.baseName) return;
    this.baseName = name;
    void this.readBase(name);
  }

  private async readBase(name: string): Promise<void> {
    const below = await readWithBases(name);
    if (name !== this.baseName) return;
    this.base = below;
    this.remake();
  }

  /** Reads the species that are named and not known yet. */
  private learnSpecies(): void {
    for (const entry of this.preset.organisms.keys()) {
      const file = beside(this.file, this.preset.speciesName(entry));
      if (!this.preset.speciesName(entry) || this.species.has(file)) continue;
      this.species.set(file, null);
      void readSpecies(file).then((found) => {
        this.species.set(file, found);
        if (found) this.remake();
      });
    }
  }

  /** The same text, now that more is known of what it builds on. */
  private remake(): void {
    this.preset = this.made(this.text);
    this.learnSpecies();
    this.keepRight();
    this.emit("text");
  }

  /** How the preset names a file that the server wrote: where it lies elsewhere, as a copy without a file yet, by its whole path. */
  nameOfWritten({ file, path }: { file: string; path: string }): string {
    return beside(this.file, file) === path ? file : path;
  }

  // Edits

  /**
   * Takes a new text as one step to undo. Steps of one `gesture` (a drag of one slider) that follow each other are
   * one step; endGesture() ends it.
   */
  change(text: string, gesture = ""): void {
    if (text === this.text) return;
    if (!gesture || gesture !== this.gesture) {
      this.undoTexts.push(this.text);
      if (this.undoTexts.length > UNDO_STEPS) this.undoTexts.shift();
      this.redoTexts = [];
    }
    this.gesture = gesture;
    this.replace(text);
  }

  endGesture(): void {
    this.gesture = "";
  }

  get canUndo(): boolean {
    return this.undoTexts.length > 0;
  }
  get canRedo(): boolean {
    return this.redoTexts.length > 0;
  }

  undo(): void {
    this.step(this.undoTexts, this.redoTexts);
  }

  redo(): void {
    this.step(this.redoTexts, this.undoTexts);
  }

  private step(from: string[], to: string[]): void {
    const text = from.pop();
    if (text === undefined) return;
    to.push(this.text);
    this.endGesture();
    this.replace(text);
  }

  private replace(text: string): void {
    this.show(text);
    this.keepRight();
    this.keep();
    this.emit("text");
  }

  /** Sets a value. Lists that stand in the base are written out first, as a list counts as a whole. */
  set(path: Path, value: unknown, gesture = ""): void {
    this.change(this.edited(this.text, path, value), gesture);
  }

  remove(path: Path): void {
    this.change(removeAt(this.writtenOut(this.text, path), path));
  }

  /** A text with a value set as set() does. */
  edited(text: string, path: Path, value: unknown): string {
    return setAt(this.writtenOut(text, path), path, value);
  }

  /** Several edits as one step. */
  batch(edit: (text: string) => string): void {
    this.change(edit(this.text));
  }

  /** The text with all that a path leads through, so that a part of it can be set. */
  writtenOut(text: string, path: Path): string {
    let out = text;
    for (let length = 1; length < path.length; length++) {
      const above = path.slice(0, length);
      const mine = getAt(this.preset.own, above);
      const all = mine ?? getAt(this.preset.whole, above) ?? this.inherited(above);
      if (mine === undefined && Array.isArray(all)) {
        out = setAt(out, above, all);
        if (above.length > 1) return out;
      } else if (all !== undefined && typeof all !== "object") {
        const field = this.schema.at(above, this.kinds);
        if (field?.type === "object" && field.shorthand) return setAt(out, above, { [field.shorthand]: all });
      }
    }
    return out;
  }

  /** What the species of an organism says at a path of the preset. */
  private inherited([first, entry, ...rest]: Path): unknown {
    return first === "organisms" && typeof entry === "number" && rest.length ? getAt(this.preset.ofSpecies(entry), rest) : undefined;
  }

  /** `finish`: what else is written into it, as a part of the same step. */
  addOrganism(organism: unknown, finish: (text: string, path: Path) => string = (text) => text): void {
    const at = this.preset.organisms.length;
    const text = at ? this.writtenOut(this.text, ["organisms", 0]) : this.text;
    this.added = at;
    this.change(finish(insertAt(text, ["organisms"], at, organism), ["organisms", at]));
    this.select(at);
  }

  /** The organisms that are selected, in their order. */
  get chosen(): number[] {
    return typeof this.selected === "number" ? [...new Set([this.selected, ...this.also])].sort((a, b) => a - b) : [];
  }

  /** Those that an act on one of them is meant for: all that are selected, if it is one of these. */
  meant(entry: number): number[] {
    return this.chosen.includes(entry) ? this.chosen : [entry];
  }

  copyOrganism(entry: number): void {
    const text = this.writtenOut(this.text, ["organisms", entry]);
    const written = sliceAt(text, ["organisms", entry]);
    if (!written) return;
    const copied = insertAt(text, ["organisms"], entry + 1, written, true);
    this.shiftShown(entry + 1, 1);
    this.change(setAt(copied, ["organisms", entry + 1, "name"], this.freeName(this.preset.nameOf(entry))));
    this.select(entry + 1);
  }

  /** As one step to undo. */
  removeOrganisms(entries: number[]): void {
    if (!entries.length) return;
    const last = [...entries].sort((a, b) => b - a);
    for (const entry of last) this.shiftShown(entry, -1);
    this.also = new Set();
    this.batch((text) => last.reduce((out, entry) => removeAt(out, ["organisms", entry]), this.writtenOut(text, ["organisms", 0])));
    this.emit("selected");
  }

  /**
   * Puts organisms, one after the other, before or after what is listed beside the first of them. What is drawn by lot may be
   * another then: lots follow the order.
   */
  moveOrganisms(entries: number[], by: 1 | -1): void {
    const { preset } = this;
    const others = [...preset.organisms.keys()].filter((i) => !entries.includes(i));
    const own = preset.groupOf(entries[0]!);
    let to = others.filter((i) => i < entries[0]!).length + by;
    // A group is passed as a whole, but by one of its own.
    const within = (): string => (to > 0 && to < others.length && preset.groupOf(others[to]!) === preset.groupOf(others[to - 1]!) ? preset.groupOf(others[to]!) : "");
    while (within() && (within() !== own || entries.length === preset.inGroup(own).length)) to += by;
    if (to < 0 || to > others.length) return;
    const order = others.toSpliced(to, 0, ...entries);
    const text = this.writtenOut(this.text, ["organisms", 0]);
    const written = entries.map((i) => sliceAt(text, ["organisms", i])!);
    const without = entries.toReversed().reduce((out, i) => removeAt(out, ["organisms", i]), text);
    const moved = (set: ReadonlySet<number>): Set<number> => new Set([...set].map((i) => order.indexOf(i)));
    this.solo = moved(this.solo);
    this.hidden = moved(this.hidden);
    this.change(written.reduce((out, one, k) => insertAt(out, ["organisms"], to + k, one, true), without));
    this.selectAll(entries.map((_, k) => to + k));
  }

  /** Lists them under one name, or, where that is empty, each by itself. */
  group(entries: number[], name: string): void {
    this.batch((text) =>
      entries.reduce((out, i) => {
        const path = ["organisms", i, "group"];
        return name ? this.edited(out, path, name) : removeAt(this.writtenOut(out, path), path);
      }, text));
  }

  /** A name that no group has yet. */
  freeGroup(): string {
    for (let i = 1; ; i++) if (!this.preset.inGroup(`group ${i}`).length) return `group ${i}`;
  }

  /** A name that no organism has yet. */
  freeName(name: string): string {
    const taken = new Set(this.preset.organisms.map((_, i) => this.preset.nameOf(i)));
    if (!taken.has(name)) return name;
    const stem = name.replace(/ \d+$/, "");
    for (let i = 2; ; i++) if (!taken.has(`${stem} ${i}`)) return `${stem} ${i}`;
  }

  /** Which organisms are shown goes with them when others come or go before them. */
  private shiftShown(from: number, by: 1 | -1): void {
    const shift = (set: Set<number>): Set<number> =>
      new Set([...set].filter((i) => by > 0 || i !== from).map((i) => (i >= from ? i + by : i)));
    this.solo = shift(this.solo);
    this.hidden = shift(this.hidden);
  }

  // What is looked at

  select(selected: Selection): void {
    if (this.selected === selected && this.picked && !this.also.size) return;
    this.selected = selected;
    this.also = new Set();
    this.picked = true;
    this.keep();
    this.emit("selected");
  }

  /** Selects organisms, of which the first is shown. */
  selectAll(entries: number[]): void {
    this.select(entries[0]!);
    this.also = new Set(entries.slice(1));
    this.emit("selected");
  }

  /** Selects an organism beside those that are, or no longer. */
  selectAlso(entry: number): void {
    if (typeof this.selected !== "number") return this.select(entry);
    const others = this.chosen.filter((i) => i !== entry);
    if (others.length < this.chosen.length && !others.length) return;
    const main = others.length < this.chosen.length ? others.at(-1)! : entry;
    this.select(main);
    this.also = new Set(others.filter((i) => i !== main));
    this.emit("selected");
  }

  /** Neither time nor selection goes beyond what there is. */
  private keepRight(): void {
    if (this.time > this.preset.end) this.setTime(this.preset.end);
    const last = this.preset.organisms.length - 1;
    this.also = new Set([...this.also].filter((i) => i <= last));
    if (typeof this.selected !== "number" || this.selected <= last) return;
    this.selected = last < 0 ? "scene" : last;
    this.emit("selected");
  }

  setTime(time: number): void {
    if (this.time === time) return;
    this.time = time;
    this.keep();
    this.emit("time");
  }

  toggle(which: "solo" | "hidden", entries: number[], on: boolean): void {
    for (const entry of entries) if (on) this[which].add(entry); else this[which].delete(entry);
    this.emit("shown");
  }

  setScene(change: Partial<SceneStatus>): void {
    this.scene = { ...this.scene, ...change };
    this.emit("scene");
  }

  setLink(link: Store["link"]): void {
    if (this.link === link) return;
    this.link = link;
    this.emit("link");
  }

  /** All that is wrong: what keeps the text from being read, or what the server says. */
  get faults(): Fault[] {
    return this.preset.syntax.length ? this.preset.faults : this.scene.errors;
  }

  keepDraft(): void {
    this.keep.stop();
    if (!this.isOpen) return;
    const { file, text, saved, disk, copy, time, selected } = this;
    saveDraft({ file, text, saved, disk, copy, time, selected, undo: this.undoTexts, redo: this.redoTexts });
  }
}
