/** A wall of nine variations to pick from: nine seeds, or nine values of one property. */

import type { Binding } from "../controls/binding";
import { anySeed, numberBox, shown } from "../controls/number";
import { isBoundless, rounded, usualScale, valueAt } from "../controls/scale";
import { el, iconButton } from "../dom";
import { setAt } from "../edits";
import { keysOf, valueAtTime, withKey } from "../keyframes";
import type { Path } from "../pointer";
import { spelled, type Field, type NumberField } from "../schema";
import type { Store } from "../store";
import { copyTo, drawPictures } from "./small_pictures";

const COUNT = 9;
const NOTHING = (): void => {};

interface Subject {
  title: string;
  values: number[];
  path: Path;
  /** What is written for a value. */
  write(value: number): unknown;
}

export interface Wall {
  element: HTMLElement;
  seeds(): void;
  vary(binding: Binding, field: Field): void;
  close(): void;
}

/** Of the film's pictures. */
const aspectOf = (store: Store): number => {
  const [w, h] = store.scene.header?.film.size ?? [16, 9];
  return w / h;
};

export function wall(store: Store): Wall {
  const title = el("h2");
  const grid = el("div.wall-grid", { "data-testid": "wall-grid" });
  const range = el("span.wall-range");
  const again = el("button.small", { type: "button", click: () => again_() }, "Nine others");
  const bar = el<HTMLProgressElement>("progress", { max: 1, "aria-label": "Variations that are as they will be" });
  const said = el("span", { role: "status" });
  const progress = el("span.wall-progress", { hidden: true, "data-testid": "wall-progress" }, bar, said);
  const element = el("section.wall", { "aria-label": "Variations", hidden: true, "data-testid": "wall" },
    el("div.pane-head", {}, title, range, progress, again, iconButton("close", "Close the variations", () => close())), grid);
  let again_: () => void = NOTHING;
  let drawing = new AbortController();
  let before: HTMLElement | null = null;

  const close = (): void => {
    drawing.abort();
    element.hidden = true;
    grid.replaceChildren();
    if (before?.isConnected) before.focus();
  };
  element.addEventListener("keydown", (event) => event.key === "Escape" && close());

  const open = (subject: Subject): void => {
    if (element.hidden) before = document.activeElement as HTMLElement;
    element.hidden = false;
    title.textContent = subject.title;
    grid.style.setProperty("--aspect", String(aspectOf(store)));
    const texts = subject.values.map((v) => setAt(store.writtenOut(store.text, subject.path), subject.path, subject.write(v)));
    const tiles = subject.values.map((value, i) => tile(shown(value), () => {
      store.change(texts[i]!);
      close();
    }));
    grid.replaceChildren(...tiles.map((t) => t.element));
    tiles[0]!.element.focus();
    drawing.abort();
    drawing = new AbortController();
    void draw(texts, tiles.map((t) => t.picture), drawing.signal);
  };

  async function draw(texts: string[], pictures: HTMLCanvasElement[], over: AbortSignal): Promise<void> {
    const docs = texts.map((text) => ({ text, file: store.file }));
    const shown = { time: store.time, solo: store.solo.size ? [...store.solo] : null, hide: [...store.hidden] };
    const finished = new Set<number>();
    const tell = (working: number | null): void => {
      progress.hidden = working === null;
      bar.value = finished.size / COUNT;
      said.textContent = `${finished.size} of ${COUNT} are as they will be`;
      pictures.forEach((figure, i) => figure.parentElement!.classList.toggle("working", i === working));
    };
    const begin = (i: number): void => {
      tell(i);
      const tile = pictures[i]!.parentElement!;
      if (!tile.classList.contains("drawn")) tile.dataset.note = "growing …";
    };
    tell(0);
    await drawPictures(docs, { aspect: aspectOf(store), shown, roughly: store.preset.organisms.length, begin }, over, (i, drawn, done) => {
      const figure = pictures[i]!;
      const tile = figure.parentElement!;
      if (typeof drawn === "string") tile.dataset.note = drawn;
      else {
        copyTo(figure, drawn);
        delete tile.dataset.note;
      }
      tile.classList.add("drawn");
      tile.classList.toggle("rough", !done);
      if (done) finished.add(i);
      tell(i);
    });
    if (!over.aborted) tell(null);
  }

  const seeds = (): void => {
    again_ = seeds;
    range.replaceChildren();
    again.hidden = false;
    open({ title: "Nine seeds", path: ["seed"], values: Array.from({ length: COUNT }, anySeed), write: (v) => v });
  };

  const vary = (binding: Binding, field: Field): void => {
    const number = (field.type === "keyed" ? field.base : field) as NumberField;
    const now = Number(valueAtTime(binding.get() ?? field.default ?? number.low, store.time));
    const { path } = binding;
    const write = (v: number): unknown => (keysOf(binding.get()) ? withKey(binding.get(), store.time, v) : v);
    const name = spelled(String(binding.rel.at(-1)));
    let [from, to] = rangeAbout(number, now);
    const show = (): void => {
      const step = (to - from) / (COUNT - 1);
      const values = Array.from({ length: COUNT }, (_, i) => (number.integer ? Math.round(from + i * step) : rounded(from + i * step, Math.abs(step) / 20 || 0.001)));
      const boxes = [numberBox("From", number, (v, done) => ((from = v), done && show())), numberBox("To", number, (v, done) => ((to = v), done && show()))];
      boxes[0]!.show(from);
      boxes[1]!.show(to);
      range.replaceChildren("from", el("span.boxed", {}, boxes[0]!), "to", el("span.boxed", {}, boxes[1]!));
      open({ title: `Nine of ${name}`, path, values, write });
    };
    again.hidden = true;
    show();
  };
  return { element, seeds, vary, close };
}

function tile(label: string, pick: () => void): { element: HTMLElement; picture: HTMLCanvasElement } {
  const picture = el<HTMLCanvasElement>("canvas", { width: 480, height: 270, "aria-hidden": "true" });
  const element = el("button.tile", { type: "button", click: pick, "data-testid": `variation:${label}` }, picture, el("span", {}, label));
  return { element, picture };
}

/** About a third of the slider's way to either side. */
function rangeAbout(field: NumberField, now: number): [number, number] {
  if (isBoundless(field)) return [now, now + COUNT - 1];
  const scale = usualScale(field, now);
  const way = scale.toWay(now);
  return [valueAt(scale, field, Math.max(0, way - 0.3)), valueAt(scale, field, Math.min(1, way + 0.3))];
}
