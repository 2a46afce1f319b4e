/** Branches by hand: one is picked, and cut, bent, made stronger or weaker. Each act is an item of the organism's `edits`. */

import { Plane, Quaternion, Raycaster, Vector3, type PerspectiveCamera } from "three";
import * as api from "../api";
import type { Picked } from "../api";
import { el, sleep } from "../dom";
import { removeAt } from "../edits";
import { say } from "../panels/dialogs";
import { lostEdits, type LostEdit } from "../lost_edits";
import { getAt } from "../pointer";
import { round } from "../rounding";
import type { Store } from "../store";
import type { Drag, Tool } from "../view/tool";
import type { View } from "../view/view";
import { bent } from "./beam";
import { Marks, touches } from "../view/marks";
import { toolButton } from "./button";
import { OtherBark, type Bark } from "./other_bark";

const COLORS = { hangs: 0xffa63d, axis: 0xffffff, handle: 0x59c36a };
const FAR = 1e4; // metres
const STRONGER = 1.25;
const HOVER = 60; // ms between questions what is under the pointer
const MOST_STEPS = 30; // nodes that are passed over

interface Edit {
  at: string;
  plant?: number;
  cut?: boolean | number;
  bend?: [number, number, number];
  strength?: number;
  bare?: boolean;
  bark?: Bark;
}

export class Branches implements Tool {
  readonly drawn = new Marks();
  readonly options: HTMLElement;
  private picked: Picked | null = null;
  private pixel = 0.001;
  private asked = 0;
  /** Where the pointer is, not asked yet. */
  private under: ReturnType<typeof rayOf> | null = null;
  private hovering = false;
  private told = el("p", { role: "status", "data-testid": "branch" }, "Click a branch.");
  private address = el<HTMLInputElement>("input", { type: "text", size: 12, "aria-label": "Address of the branch", "data-tip": "Numbers of branches counted from the foot, with slashes, and the share of its length: 3/1:0.4", "data-testid": "branch-address" });
  private year = el<HTMLInputElement>("input.number", { type: "number", min: "1", step: "1", size: 5, "aria-label": "Year in which it is cut", "data-testid": "cut-year" });
  private lost = el("details.lost-edits", { hidden: true, "data-testid": "lost-edits" }) as HTMLDetailsElement;
  private lostShown = "";
  private bare: HTMLElement;
  private bark = new OtherBark((bark) => this.wear(bark), () => this.store.endGesture());
  private byYear: HTMLElement;
  private acts: HTMLElement;

  constructor(
    private store: Store,
    private view: View,
  ) {
    const button = (name: string, label: string, tip: string, click: () => void): HTMLElement => toolButton(`branch:${name}`, label, tip, click);
    this.byYear = el("span.cluster", {}, this.year, button("cut-year", "Cut in that year", "The tree answers with new shoots", () => this.cut(Number(this.year.value))));
    this.bare = button("bare", "Bare", "No leaves, flowers or fruit on it, nor on what hangs on it", () => this.strip());
    this.acts = el(
      "div.cluster", { role: "group", "aria-label": "What is done with the branch", hidden: true },
      button("cut", "Cut", "Saws it off there (Delete)", () => this.cut(true)),
      this.byYear,
      button("stronger", "Stronger", "Longer and thicker, with all that hangs on it", () => this.strengthen(STRONGER)),
      button("weaker", "Weaker", "Shorter and thinner", () => this.strengthen(1 / STRONGER)),
      this.bare,
      this.bark.element,
      button("undo", "As it grew", "Takes back all that was done with it", () => this.forget()),
    );
    const find = button("find", "Find", "Picks the branch of that address", () => void this.find(this.address.value));
    const go = (name: string, label: string, tip: string, to: (axis: number[], step: number) => number[] | null): HTMLElement => button(name, label, tip, () => void this.go(to));
    this.options = el(
      "div.tool-options", { "data-testid": "branches" }, this.told,
      el("div.cluster", {}, this.address, find,
        go("lower", "◂", "The branch before it", (axis, step) => (axis.at(-1)! > step ? [...axis.slice(0, -1), axis.at(-1)! - step] : null)),
        go("upper", "▸", "The branch after it", (axis, step) => (axis.length ? [...axis.slice(0, -1), axis.at(-1)! + step] : null)),
        go("parent", "▾", "What it grows on", (axis, step) => (axis.length && step === 1 ? axis.slice(0, -1) : null)),
        go("child", "▴", "The first that grows on it", (axis, step) => [...axis, step])),
      this.acts,
      this.lost,
    );
    this.store.on("scene", () => this.tellLost());
    this.address.addEventListener("keydown", (event) => event.key === "Enter" && void this.find(this.address.value));
  }

  click(ray: Raycaster): void {
    void this.ask(rayOf(ray));
  }

  /** The branch under the pointer is drawn over, and named, before it is clicked: one question at a time. */
  hover(ray: Raycaster | null): void {
    this.under = ray && rayOf(ray);
    if (!this.under) this.view.trace([]);
    else if (!this.hovering) void this.follow();
  }

  private async follow(): Promise<void> {
    this.hovering = true;
    while (this.under) {
      const asked = this.under;
      const found = await api.pick(this.store.doc, this.store.time, asked).catch(() => null);
      await sleep(HOVER);
      if (this.under === asked) this.under = null;
      else if (!this.under) break; // it has left
      this.view.trace(found?.beam.filter((_, i) => i % 4 < 3) ?? []);
    }
    this.hovering = false;
  }

  /** The place that is picked is taken hold of; elsewhere the eye is turned. */
  drag(ray: Raycaster): Drag | null {
    const { picked } = this;
    if (!picked) return null;
    const from = new Vector3(...picked.point);
    if (!touches(ray.ray, from, this.pixel)) return null;
    const plane = new Plane().setFromNormalAndCoplanarPoint(ray.ray.direction, from);
    const node = nearestNode(picked.beam, from);
    const target = from.clone();
    return {
      move: (now) => {
        if (!now.ray.intersectPlane(plane, target)) return;
        this.show(bent(picked.beam, node, target));
      },
      end: () => this.bend(target.sub(from)),
    };
  }

  scaleTo(camera: PerspectiveCamera, pixel: number): void {
    this.pixel = pixel;
    this.drawn.scaleTo(camera, pixel);
  }

  /** Says which edits find no branch, where these are others than before. */
  private tellLost(): void {
    const { header, notes } = this.store.scene;
    if (!header || header.missing.length || header.coarse) return;
    const lost = lostEdits(this.store, notes);
    const now = JSON.stringify([this.store.file, lost]);
    if (now === this.lostShown) return;
    this.lostShown = now;
    this.lost.hidden = !lost.length;
    this.lost.replaceChildren(
      el("summary", {}, `${lost.length === 1 ? "1 edit finds" : `${lost.length} edits find`} no branch`),
      el("p.hint", {}, "They stay in the preset and count again where there is such a branch, as with the seed that they were made for."),
      el("ul", {}, ...lost.map((one) => el("li", {}, `${this.store.preset.nameOf(one.entry)}: ${one.what}. ${one.why}`))),
      el("button.small", { type: "button", "data-testid": "forget-lost", click: () => this.forgetLost(lost) }, "Take them out"),
    );
    if (lost.length) say(`${lost.length === 1 ? "1 edit of branches finds none" : `${lost.length} edits of branches find none`}: ${lost.map((one) => one.what).slice(0, 5).join("; ")}${lost.length > 5 ? " …" : ""}`);
  }

  private forgetLost(lost: LostEdit[]): void {
    const { store } = this;
    const last = [...lost].sort((a, b) => b.index - a.index);
    store.batch((text) => last.reduce((out, { entry, index }) => {
      const path = ["organisms", entry, "edits", index];
      return removeAt(store.writtenOut(out, path), path);
    }, text));
  }

  /** What was picked may be another now. */
  refresh(): void {
    if (this.picked) void this.ask({ entry: this.picked.entry, plant: this.picked.plant, at: this.picked.at });
  }

  key(event: KeyboardEvent): boolean {
    if (event.key !== "Delete" || !this.picked) return false;
    this.cut(true);
    return true;
  }

  /** To the next branch that there is: trees count the nodes of an axis, not all of which bear one. */
  private async go(to: (axis: number[], step: number) => number[] | null): Promise<void> {
    const parts = (this.picked?.at ?? "").split(":")[0]!.split("/").filter(Boolean);
    const stem = parts[0]?.startsWith("#") ? [parts.shift()!] : [];
    for (let step = 1; step <= MOST_STEPS; ++step) {
      const next = to(parts.map(Number), step);
      if (!next || (await this.find(`${[...stem, ...next].join("/")}:0.5`))) return;
    }
  }

  private async find(at: string): Promise<boolean> {
    const { selected } = this.store;
    const entry = this.picked?.entry ?? (typeof selected === "number" ? selected : 0);
    return this.ask({ entry, plant: this.picked?.plant ?? 0, at }, `There is no branch ${at}.`);
  }

  /** Whether there is one. */
  private async ask(where: Parameters<typeof api.pick>[2], none = "No branch is there."): Promise<boolean> {
    const number = ++this.asked;
    try {
      const found = await api.pick(this.store.doc, this.store.time, where);
      if (number !== this.asked) return false;
      if (found || "from" in where) this.take(found);
      if (!found) this.told.textContent = none;
      return found !== null;
    } catch (error) {
      if (number === this.asked) this.told.textContent = (error as Error).message;
      return false;
    }
  }

  private take(found: Picked | null): void {
    this.picked = found;
    this.acts.hidden = found === null;
    if (found) {
      this.byYear.hidden = found.year === null;
      if (found.year !== null) this.year.value = String(Math.max(1, Math.round(found.year)));
      this.address.value = found.at;
      this.store.select(found.entry);
      const cm = round(200 * found.radius, 1);
      const own = this.edits(found).filter((e) => this.same(found, e));
      this.bare.setAttribute("aria-pressed", String(own.some((e) => e.bare === true)));
      this.bark.show(own.find((e) => e.bark)?.bark, this.store.preset.whole.palettes);
      this.told.textContent = `${this.store.preset.nameOf(found.entry)}, branch ${found.at}: ${cm} cm thick. Drag the green point to bend it.`;
    }
    this.show();
  }

  private show(axis: Vector3[] | null = null): void {
    this.drawn.clear();
    const { picked } = this;
    if (picked) {
      if (!axis) this.drawn.segments(picked.hangs.filter((_, i) => i % 4 < 3), COLORS.hangs);
      this.drawn.line(axis ? axis.flatMap((p) => p.toArray()) : picked.beam.filter((_, i) => i % 4 < 3), COLORS.axis);
      this.drawn.handle(axis ? axis[nearestNode(picked.beam, new Vector3(...picked.point))]! : new Vector3(...picked.point), COLORS.handle);
    }
    this.view.redraw();
  }

  private cut(cut: boolean | number): void {
    if (!this.picked || (typeof cut === "number" && !(cut > 0))) return;
    this.write((all, same) => [...all.filter((e) => !same(e) || e.cut === undefined), { cut }]);
    this.take(null);
    this.told.textContent = "Cut. Undo brings it back.";
  }

  private strengthen(factor: number): void {
    this.write((all, same) => {
      const was = all.find((e) => same(e) && e.strength !== undefined);
      return [...all.filter((e) => e !== was), { strength: round((was?.strength ?? 1) * factor, 2) }];
    });
  }

  /** By metres of the world, further than it was bent before. */
  private bend(by: Vector3): void {
    const { picked } = this;
    if (!picked) return;
    by.applyQuaternion(new Quaternion(...picked.frame).invert()).divideScalar(picked.size);
    this.write((all, same) => {
      const was = all.find((e) => same(e) && e.bend !== undefined);
      const sum = by.add(new Vector3(...(was?.bend ?? [0, 0, 0])));
      return [...all.filter((e) => e !== was), { bend: sum.toArray().map((x) => round(x)) as [number, number, number] }];
    });
  }

  /** Takes its leaves, or gives them back. */
  private strip(): void {
    this.write((all, same) => {
      const was = all.find((e) => same(e) && e.bare === true);
      return was ? all.filter((e) => e !== was) : [...all, { bare: true }];
    });
  }

  /** Gives it another bark, or the plant's own again. */
  private wear(bark: Bark | undefined): void {
    const { picked } = this;
    if (!picked) return;
    const index = this.edits(picked).findIndex((e) => this.same(picked, e) && e.bark !== undefined);
    if (index < 0 && !bark) return;
    if (index >= 0 && bark) return this.store.set(["organisms", picked.entry, "edits", index, "bark"], bark, "bark of a branch");
    this.write((all) => (bark ? [...all, { bark }] : all.filter((_, i) => i !== index)));
  }

  private forget(): void {
    this.write((all, same) => all.filter((e) => !same(e)));
  }

  private edits({ entry }: Picked): Edit[] {
    const given = getAt(this.store.preset.organism(entry), ["edits"]);
    return Array.isArray(given) ? (given as Edit[]) : [];
  }

  private same(picked: Picked, edit: Edit): boolean {
    return edit.at === picked.at && (edit.plant ?? picked.plant) === picked.plant;
  }

  /** Edits the list of the organism; an item without `at` is one of the branch that is picked. */
  private write(change: (all: Edit[], same: (edit: Edit) => boolean) => Partial<Edit>[]): void {
    const { picked, store } = this;
    if (!picked) return;
    const all = this.edits(picked);
    const alone = (this.view.head?.entries[picked.entry]?.specimens ?? 1) === 1;
    const edits = change(all, (edit) => this.same(picked, edit)).map((edit) => (edit.at !== undefined ? edit : { at: picked.at, ...(alone ? {} : { plant: picked.plant }), ...edit }));
    const path = ["organisms", picked.entry, "edits"];
    // What is added at the end is written there, so that comments among the others stay.
    const added = edits.length === all.length + 1 && all.every((edit, i) => edit === edits[i]);
    if (added) store.set([...path, all.length], edits.at(-1));
    else if (edits.length) store.set(path, edits);
    else if (all.length) store.remove(path);
    say(edits.length === 1 ? "1 edit of branches." : `${edits.length} edits of branches.`);
  }
}

/** From the eye on, as far as one sees. */
function rayOf({ ray: { origin, direction } }: Raycaster): { from: [number, number, number]; to: [number, number, number] } {
  return { from: origin.toArray(), to: origin.clone().addScaledVector(direction, FAR).toArray() };
}

function nearestNode(beam: readonly number[], at: Vector3): number {
  let best = 0;
  let least = Infinity;
  for (let i = 0; 4 * i < beam.length; ++i) {
    const away = at.distanceToSquared(new Vector3(beam[4 * i], beam[4 * i + 1], beam[4 * i + 2]));
    if (away < least) [best, least] = [i, away];
  }
  return Math.max(1, best);
}
