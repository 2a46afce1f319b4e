/** The page to begin with: all shipped presets, each a copy to play with by one click. */

import * as api from "../api";
import { el, icon } from "../dom";
import type { Listed } from "../api";
import { Looks } from "../looks";
import type { Store } from "../store";
import { say } from "./dialogs";

/** Presets of a folder stand together; those at the top come first. */
const groupOf = (listed: Listed): string => listed.name.split("/").slice(0, -1).join("/");
const TITLES: Record<string, string> = { "": "Scenes and single ones", lsystems: "L-systems", trees: "Trees", forest: "Forest", garden: "Garden", ivy: "Ivy", grammars: "Grammars" };

export function gallery(store: Store): { element: HTMLElement; show(): void; focus(): void } {
  const search = el<HTMLInputElement>("input.text", { type: "search", placeholder: "Search presets", "aria-label": "Search presets", "data-testid": "gallery-search" });
  const body = el("div.shelves");
  let own: Listed[] = [];
  const looks = new Looks();
  store.on("opened", () => looks.stop());
  const empty = el("button", { type: "button", "data-testid": "new-preset", click: () => begin() }, "An empty one");
  const element = el("section.gallery", { "aria-label": "Gallery", "data-testid": "gallery", hidden: true },
    el("div.gallery-head", {}, el("div", {}, el("h1", {}, "Begin with a preset"), el("p.hint", {}, "What is shipped opens as a copy to play with and stays as it is; your own files open as they are.")), el("span.search", {}, icon("search"), search), empty), body);

  const begin = (): void =>
    store.open({ file: store.folder + "untitled.json", disk: null, copy: true, text: '{\n  "version": 2,\n  "title": "Untitled",\n  "seed": 1,\n  "film": {"frames": 1},\n  "scene": {"setting": "studio"},\n  "organisms": []\n}\n' });

  /** What is one's own is opened as it is, what is shipped as a copy. */
  async function open(file: string, isOwn: boolean): Promise<void> {
    try {
      const loaded = await api.preset(file);
      store.open(isOwn ? loaded : { ...loaded, copy: true });
    } catch (error) {
      say((error as Error).message, true);
    }
  }
  const pictureOf = (listed: Listed): HTMLElement => {
    const picture = el<HTMLImageElement>("img", { alt: "", loading: "lazy" });
    picture.addEventListener("error", () => picture.replaceWith(el("span.blank", {}, icon("gallery"))));
    if (listed.picture) picture.src = api.galleryPicture(listed.picture);
    else looks.want(picture, (signal) => api.look(listed.file, signal));
    return picture;
  };
  const card = (listed: Listed, isOwn = false): HTMLElement => {
    const picture = pictureOf(listed);
    return el("li", {}, el("button.card", { type: "button", "data-testid": `${isOwn ? "own" : "card"}:${listed.name}`, "data-file": listed.file, click: () => void open(listed.file, isOwn) }, picture, el("span", {}, listed.title || listed.name), el("small", {}, listed.name)));
  };
  const render = (): void => {
    looks.stop();
    const words = search.value.trim().toLowerCase();
    const called = (p: Listed): boolean => `${p.title} ${p.name}`.toLowerCase().includes(words);
    const found = store.presets.filter(called);
    const mine = own.filter(called);
    const groups = [...new Set(found.map(groupOf))].sort();
    body.replaceChildren(...groups.map((g) => el("section", {}, el("h2", {}, TITLES[g] ?? g), el("ul.cards", {}, ...found.filter((p) => groupOf(p) === g).map((p) => card(p))))));
    if (mine.length) body.prepend(el("section", {}, el("h2", {}, "Your files"), el("ul.cards", {}, ...mine.map((p) => card(p, true)))));
    if (!found.length && !mine.length) body.append(el("p.hint", {}, "No preset is called so."));
  };
  /** One's own files come as soon as the server has found them. */
  const show = (): void => {
    render();
    void api.files().then((files) => {
      const same = JSON.stringify(files) === JSON.stringify(own);
      own = files;
      if (!same) render();
    }, () => undefined);
  };
  search.addEventListener("input", render);
  /** The card that was opened last, else the first thing there is to do. */
  const focus = (): void => (body.querySelector<HTMLElement>(`[data-file="${CSS.escape(store.file)}"]`) ?? search).focus();
  return { element, show, focus };
}
