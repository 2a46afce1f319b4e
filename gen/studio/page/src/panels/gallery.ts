/** The page to begin with: all shipped presets, each a copy to play with by one click. */

import * as api from "../api";
import { el, icon } from "../dom";
import type { Listed } from "../api";
import type { Store } from "../store";
import { say } from "./dialogs";

/** Presets of a folder stand together; those at the top come first. */
const groupOf = (listed: Listed): string => listed.name.split("/").slice(0, -1).join("/");
const TITLES: Record<string, string> = { "": "Scenes and single ones", lsystems: "L-systems", trees: "Trees", forest: "Forest", garden: "Garden", ivy: "Ivy", grammars: "Grammars" };

export function gallery(store: Store): { element: HTMLElement; show(): void } {
  const search = el<HTMLInputElement>("input.text", { type: "search", placeholder: "Search presets", "aria-label": "Search presets", "data-testid": "gallery-search" });
  const body = el("div.shelves");
  const empty = el("button", { type: "button", "data-testid": "new-preset", click: () => begin() }, "An empty one");
  const element = el("section.gallery", { "aria-label": "Gallery", "data-testid": "gallery", hidden: true },
    el("div.gallery-head", {}, el("div", {}, el("h1", {}, "Begin with a preset"), el("p.hint", {}, "One click makes a copy to play with. What is shipped stays as it is.")), el("span.search", {}, icon("search"), search), empty), body);

  const begin = (): void =>
    store.open({ file: store.folder + "untitled.json", disk: null, copy: true, text: '{\n  "title": "Untitled",\n  "seed": 1,\n  "film": {"frames": 1},\n  "scene": {"setting": "studio"},\n  "organisms": []\n}\n' });

  async function open(file: string): Promise<void> {
    try {
      store.open({ ...(await api.preset(file)), copy: true });
    } catch (error) {
      say((error as Error).message, true);
    }
  }
  const card = (listed: Listed): HTMLElement => {
    const picture = listed.picture ? el("img", { src: api.galleryPicture(listed.picture), alt: "", loading: "lazy" }) : el("span.blank", {}, icon("gallery"));
    return el("li", {}, el("button.card", { type: "button", "data-testid": `card:${listed.name}`, click: () => void open(listed.file) }, picture, el("span", {}, listed.title || listed.name), el("small", {}, listed.name)));
  };
  const show = (): void => {
    const words = search.value.trim().toLowerCase();
    const found = store.presets.filter((p) => `${p.title} ${p.name}`.toLowerCase().includes(words));
    const groups = [...new Set(found.map(groupOf))].sort();
    body.replaceChildren(...groups.map((g) => el("section", {}, el("h2", {}, TITLES[g] ?? g), el("ul.cards", {}, ...found.filter((p) => groupOf(p) === g).map(card)))));
    if (!found.length) body.append(el("p.hint", {}, "No preset is called so."));
  };
  search.addEventListener("input", show);
  return { element, show };
}
