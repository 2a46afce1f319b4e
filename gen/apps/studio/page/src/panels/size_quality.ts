/** How large and how carefully a picture or a film is to be rendered; what was chosen last is kept. */

import type { Quality } from "../api";
import { el } from "../dom";
import { sizeFor } from "../film_size";
import { isObject } from "../pointer";
import type { Store } from "../store";

/** All of the film's own shape: by its size, or so many pixels wide. */
const SIZES: Record<string, string> = { film: "as the film", half: "half the film", double: "twice the film", "320": "320 wide", "640": "640 wide", "1280": "1280 wide", "1920": "1920 wide" };

export interface SizeAndQuality {
  fields: HTMLElement[];
  size(): [number, number];
  quality(): Quality;
  keep(): void;
}

/** `name` begins the marks of its fields: "render-size". */
export function sizeAndQuality(store: Store, name: string): SizeAndQuality {
  const key = `frond.${name}`;
  const said = JSON.parse(localStorage.getItem(key) ?? "{}") as { size?: string; quality?: string };
  const size = el<HTMLSelectElement>("select", { "aria-label": "Size", "data-testid": `${name}-size` }, ...Object.keys(SIZES).map((value) => el("option", { value })));
  const quality = el<HTMLSelectElement>("select", { "aria-label": "Quality", "data-testid": `${name}-quality` }, ...["draft", "good", "best"].map((q) => el("option", { value: q }, q)));
  size.value = said.size !== undefined && said.size in SIZES ? said.size : "film";
  quality.value = said.quality ?? "draft";
  const filmSize = (): [number, number] => {
    const film = isObject(store.preset.whole.film) ? store.preset.whole.film.size : undefined;
    return store.scene.header?.film.size ?? (Array.isArray(film) ? (film as [number, number]) : [480, 270]);
  };
  const nameSizes = (): void => {
    for (const option of size.options) option.textContent = `${SIZES[option.value]}, ${sizeFor(option.value, filmSize()).join("×")}`;
  };
  nameSizes();
  store.on(["text", "scene"], nameSizes);
  return {
    fields: [el("label", {}, el("span", {}, "Size"), size), el("label", {}, el("span", {}, "Quality"), quality)],
    size: () => sizeFor(size.value, filmSize()),
    quality: () => quality.value as Quality,
    keep: () => localStorage.setItem(key, JSON.stringify({ size: size.value, quality: quality.value })),
  };
}
