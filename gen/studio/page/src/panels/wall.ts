/** A wall of nine variations to pick from: nine seeds, or nine values of one property. */

import * as api from "../api";
import type { Binding } from "../controls/binding";
import { anySeed, numberBox, shown } from "../controls/number";
import { isBoundless, rounded, scaleOf, valueAt } from "../controls/scale";
import { el, iconButton, sleep } from "../dom";
import { setAt } from "../edits";
import { keysOf, valueAtTime, withKey } from "../keyframes";
import type { Path } from "../pointer";
import { spelled, type Field, type NumberField } from "../schema";
import type { Store } from "../store";
import { View } from "../view/view";

const COUNT = 9;
/** How much of the view the preset's frame takes. */
const FRAME = 0.94;
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

export function wall(store: Store): Wall {
  const title = el("h2");
  const grid = el("div.wall-grid", { "data-testid": "wall-grid" });
  const range = el("span.wall-range");
  const again = el("button.small", { type: "button", click: () => again_() }, "Nine others");
  const element = el("section.wall", { "aria-label": "Variations", hidden: true, "data-testid": "wall" },
    el("div.pane-head", {}, title, range, again, iconButton("close", "Close the variations", () => close())), grid);
  let again_: () => void = NOTHING;
  let round = 0;
  let before: HTMLElement | null = null;

  const close = (): void => {
    round++;
    element.hidden = true;
    grid.replaceChildren();
    if (before?.isConnected) before.focus();
  };
  element.addEventListener("keydown", (event) => event.key === "Escape" && close());

  const open = (subject: Subject): void => {
    if (element.hidden) before = document.activeElement as HTMLElement;
    element.hidden = false;
    title.textContent = subject.title;
    const [w, h] = store.scene.header?.film.size ?? [16, 9];
    grid.style.setProperty("--aspect", `${w} / ${h}`);
    const texts = subject.values.map((v) => setAt(store.writtenOut(store.text, subject.path), subject.path, subject.write(v)));
    const tiles = subject.values.map((value, i) => tile(shown(value), () => {
      store.change(texts[i]!);
      close();
    }));
    grid.replaceChildren(...tiles.map((t) => t.element));
    tiles[0]!.element.focus();
    void draw(texts, tiles.map((t) => t.picture), ++round);
  };

  /** One view out of sight draws all nine, one after the other. */
  async function draw(texts: string[], pictures: HTMLCanvasElement[], mine: number): Promise<void> {
    const [w, h] = store.scene.header?.film.size ?? [16, 9];
    const host = el("div.offscreen", { "aria-hidden": "true", inert: true });
    host.style.width = `${Math.round(360 * Math.min(1, w / h))}px`;
    host.style.height = `${Math.round((360 * Math.min(1, w / h) * h) / w)}px`;
    document.body.append(host);
    const view = new View(host, { picked: NOTHING, placed: NOTHING, key: NOTHING, camera: NOTHING });
    view.lookThrough(true);
    // It flies there.
    const there = sleep(600);
    const session = crypto.randomUUID();
    try {
      for (let i = 0; i < texts.length && mine === round; i++) {
        const request = { doc: { text: texts[i]!, file: store.file }, time: store.time, have: view.have(), solo: store.solo.size ? [...store.solo] : null, hide: [...store.hidden], ask: 20 };
        const answer = await api.scene(session, i + 1, request);
        const figure = pictures[i]!;
        if (mine !== round) break;
        if (answer.is === "picture") {
          view.show(answer.bytes);
          await there;
          await view.drawn();
          await copyPicture(view, host.querySelector("canvas"), figure, w / h);
        } else figure.parentElement!.dataset.note = answer.is === "long" ? "too large for the wall" : "cannot be grown";
        figure.parentElement!.classList.add("drawn");
      }
    } catch (error) {
      for (const figure of pictures) figure.parentElement!.dataset.note = (error as Error).message;
    } finally {
      view.dispose();
      host.remove();
    }
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

/** Copies what the view draws within the preset's frame: in the very frame that draws it, as it is not kept for longer. */
async function copyPicture(view: View, from: HTMLCanvasElement | null, to: HTMLCanvasElement, aspect: number): Promise<void> {
  if (!from) return;
  void view.drawn();
  await new Promise(requestAnimationFrame);
  const width = FRAME * Math.min(from.width, from.height * aspect);
  const height = width / aspect;
  to.width = width;
  to.height = height;
  to.getContext("2d")?.drawImage(from, (from.width - width) / 2, (from.height - height) / 2, width, height, 0, 0, width, height);
}

/** About a third of the slider's way to either side. */
function rangeAbout(field: NumberField, now: number): [number, number] {
  if (isBoundless(field)) return [now, now + COUNT - 1];
  const scale = scaleOf(field);
  const way = scale.toWay(now);
  return [valueAt(scale, field, Math.max(0, way - 0.3)), valueAt(scale, field, Math.min(1, way + 0.3))];
}
