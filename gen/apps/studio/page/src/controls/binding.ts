/** Where the value of a control stands in the preset: in an organism, in what counts for all, or elsewhere. */

import { removeAt, setAt } from "../edits";
import { getAt, isObject, toPointer, type Path } from "../pointer";
import type { Scope } from "../preset";
import type { Store } from "../store";

export class Binding {
  /**
   * `rel`: the path within the organism `entry`, or within the preset where that is null. `property`: the part of `rel`
   * by which an organism and what counts for all are told apart; what is in a list goes with the list.
   */
  constructor(
    readonly store: Store,
    readonly entry: number | null,
    readonly rel: Path,
    private above: { binding: Binding; shorthand?: string } | null = null,
    readonly property: Path = rel,
  ) {}

  /** A member of the object; of one that a plain value may stand for, `shorthand` is the member that it means. */
  member(key: string, shorthand?: string): Binding {
    const inList = this.property.length < this.rel.length;
    return new Binding(this.store, this.entry, [...this.rel, key], { binding: this, shorthand }, inList ? this.property : undefined);
  }

  item(index: number): Binding {
    return new Binding(this.store, this.entry, [...this.rel, index], { binding: this }, this.property);
  }

  /** What counts there; undefined: nothing is said, so the built-in default. */
  get(): unknown {
    if (!this.above) {
      const { preset } = this.store;
      return getAt(this.entry === null ? preset.whole : preset.organism(this.entry), this.rel);
    }
    const key = this.rel.at(-1)!;
    const value = this.above.binding.get();
    if (isObject(value) || Array.isArray(value)) return (value as Record<string | number, unknown>)[key];
    return key === this.above.shorthand ? value : undefined;
  }

  get scope(): Scope {
    if (this.entry !== null) return this.store.preset.scope(this.entry, this.property);
    return this.get() === undefined ? "unset" : "own";
  }

  /** Does its species say something of it? */
  get inSpecies(): boolean {
    return this.entry !== null && getAt(this.store.preset.ofSpecies(this.entry), this.property) !== undefined;
  }

  get forced(): boolean {
    return this.entry !== null && this.store.preset.isForced(this.property);
  }

  /** Where a change is written. */
  get path(): Path {
    return this.pathIn(this.scope);
  }

  get pointer(): string {
    return toPointer(this.path);
  }

  private pathIn(scope: Scope): Path {
    if (this.entry === null) return this.rel;
    return scope === "all" ? ["defaults", ...this.rel] : ["organisms", this.entry, ...this.rel];
  }

  /** Sets it, of all organisms that are selected and can have it. `done`: the drag has ended, and with it the step that undo takes back. */
  set(value: unknown, done = true): void {
    const { store } = this;
    store.change([this, ...this.others].reduce((text, one) => store.edited(text, one.path, value), store.text), this.pointer);
    if (done) store.endGesture();
  }

  /** The same property of the other organisms that are selected, but for what is in a list, which they may not have. */
  private get others(): Binding[] {
    const { store, entry, rel, property } = this;
    if (entry === null || property.length < rel.length) return [];
    return store.meant(entry)
      .filter((other) => other !== entry && store.schema.at(["organisms", other, ...rel], store.kinds))
      .map((other) => new Binding(store, other, rel));
  }

  /** Can it be taken out of the text? What a base or a species says cannot. */
  get canReset(): boolean {
    return getAt(this.store.preset.own, this.path) !== undefined || this.isShort;
  }

  private get isShort(): boolean {
    const { binding, shorthand } = this.above ?? {};
    return shorthand === this.rel.at(-1) && binding !== undefined && !isObject(binding.get()) && binding.canReset;
  }

  reset(): void {
    const paths = [this.isShort ? this.above!.binding.path : this.path, ...this.others.filter((one) => one.canReset).map((one) => one.path)];
    this.store.batch((text) => paths.reduce((out, path) => removeAt(this.store.writtenOut(out, path), path), text));
  }

  /** Takes the value from what counts for all, which becomes this one's where there is none yet. */
  useForAll(fallback: unknown): void {
    const { store, entry, property } = this;
    if (entry === null) return;
    const value = getAt(store.preset.organism(entry), property) ?? fallback;
    const own = ["organisms", entry, ...property];
    store.batch((text) => {
      const hasAll = getAt(store.preset.defaults, property) !== undefined;
      const shared = hasAll ? text : setAt(store.writtenOut(text, ["defaults", ...property]), ["defaults", ...property], value);
      return removeAt(store.writtenOut(shared, own), own);
    });
  }

  /** Gives the organism a value of its own, the one that counts now. */
  useOwn(fallback: unknown): void {
    const { store, entry, property } = this;
    if (entry === null) return;
    const value = getAt(store.preset.organism(entry), property) ?? fallback;
    const own = ["organisms", entry, ...property];
    store.batch((text) => setAt(store.writtenOut(this.withoutForce(text), own), own, value));
  }

  /** Makes the scene's value count for all, whatever they say themselves; or ends that. */
  toggleForce(): void {
    const { store } = this;
    if (this.forced) return store.batch((text) => this.withoutForce(text));
    store.batch((text) => setAt(text, ["force"], [...store.preset.force, this.property.join("/")]));
  }

  private withoutForce(text: string): string {
    if (!this.forced) return text;
    const path = this.property.join("/");
    const kept = this.store.preset.force.filter((f) => path !== f && !path.startsWith(f + "/"));
    return setAt(text, ["force"], kept);
  }
}
