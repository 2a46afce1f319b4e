/** Renders: how the next is made, and a strip of those there are. */

import * as api from "../api";
import { el, sleep } from "../dom";
import type { Store } from "../store";
import { say } from "./dialogs";
import { describe, type PicturePane } from "./picture";
import { sizeAndQuality } from "./size_quality";

export interface Renders {
  element: HTMLElement;
  start(): Promise<void>;
  reload(): Promise<void>;
  goBack(id: string): Promise<void>;
  cancel(id: string): void;
}

export function renders(store: Store, pane: () => PicturePane): Renders {
  const form = sizeAndQuality(store, "render");
  const begin = el("button.primary", { type: "button", "data-testid": "render-start", click: () => void start() }, "Render at this time");
  const compare = el<HTMLButtonElement>("button.small", { type: "button", disabled: true, "data-testid": "compare", click: () => compareChosen() }, "Compare two");
  const strip = el("ul.strip", { "aria-label": "Past renders", "data-testid": "renders" });
  const element = el("div.renders-panel", {},
    el("div.render-form", {}, ...form.fields, begin, compare), strip);
  let list: api.PastRender[] = [];
  let chosen: string[] = [];

  async function start(): Promise<void> {
    form.keep();
    try {
      const answer = await api.render(store.doc, store.time, form.size(), form.quality());
      if (Array.isArray(answer)) return say(answer[0]?.text ?? "This preset cannot be rendered", true);
      await reload();
      await follow(answer.id);
    } catch (error) {
      say((error as Error).message, true);
    }
  }
  /** Shows how it comes along, as long as nothing else is looked at. */
  async function follow(id: string): Promise<void> {
    const render = list.find((r) => r.id === id);
    if (!render) return;
    pane().show(render, null);
    for (;;) {
      const now = await api.renderState(id);
      const changed = render.state !== now.state;
      Object.assign(render, { state: now.state, seconds: now.seconds });
      if (changed) show();
      if (pane().shown() === id) pane().show(render, now);
      if (now.state !== "growing" && now.state !== "rendering") break;
      await sleep(300);
    }
  }
  async function reload(): Promise<void> {
    list = (await api.renders()).reverse();
    show();
  }
  const choose = (id: string, both: boolean): void => {
    chosen = both ? [...chosen.filter((c) => c !== id), id].slice(-2) : [id];
    show();
    const render = list.find((r) => r.id === id)!;
    if (chosen.length === 2) return compareChosen();
    const running = render.state === "growing" || render.state === "rendering";
    if (running) void follow(id).catch(() => undefined);
    else pane().show(render, null);
  };
  const compareChosen = (): void => {
    const [a, b] = chosen.length === 2 ? chosen : list.filter((r) => r.state === "done").map((r) => r.id);
    const [first, second] = [list.find((r) => r.id === a), list.find((r) => r.id === b)];
    if (first && second) pane().compare(first, second);
  };
  const show = (): void => {
    compare.disabled = list.filter((r) => r.state === "done").length < 2;
    const cards = list.map((r) => {
      const picture = r.state === "done" ? el("img", { src: api.renderPicture(r.id), alt: "", loading: "lazy" }) : el("span.blank", {}, r.state);
      return el("li", {}, el("button.card", { type: "button", "aria-pressed": String(chosen.includes(r.id)), "data-tip": "Shift and click: compare with the one chosen", click: (e: MouseEvent) => choose(r.id, e.shiftKey && chosen.length > 0) },
        picture, el("span", {}, `${r.title || "untitled"}`), el("small", {}, describe(r))));
    });
    strip.replaceChildren(...(cards.length ? cards : [el("li.hint", {}, "Renders will be kept here as long as the server runs, each with its preset.")]));
  };
  show();
  return {
    element,
    start,
    reload,
    async goBack(id): Promise<void> {
      const doc = await api.renderDoc(id);
      store.change(doc.text);
      say("The preset is as it was rendered. Undo brings the other back.");
    },
    cancel: (id) => void api.cancelRender(id),
  };
}
