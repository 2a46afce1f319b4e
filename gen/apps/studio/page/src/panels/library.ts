/** The library: plants of all presets to drag into the view, and materials to drag onto what stands there. */

import * as api from "../api";
import { el, icon } from "../dom";
import { Looks } from "../looks";
import { round } from "../rounding";
import { applyMaterial, exampleOf, shippedMaterials, type Material } from "../materials";
import type { Store } from "../store";
import type { View } from "../view/view";
import { say } from "./dialogs";
import { addOfSpecies, calledBy } from "./species_panel";

/** What is dragged is one of ours. */
const TYPE = "application/x-frond";
/** Folders whose presets are no organisms to take over. */
const NOT_THESE = /^(asking|grammars|models)\//;

interface Card {
  key: string;
  title: string;
  detail: string;
  picture: HTMLImageElement | string;
  /** Puts it where the pointer is, or in the middle of the view. */
  use(at: { x: number; y: number } | null): void;
}

/** `stage` is where things are dropped. */
export function library(store: Store, view: View, stage: HTMLElement): { element: HTMLElement; opened(): void; closed(): void } {
  const looks = new Looks();
  const search = el<HTMLInputElement>("input.text", { type: "search", placeholder: "Search the library", "aria-label": "Search the library", "data-testid": "library-search", input: () => show() });
  const kinds = (["organisms", "materials"] as const).map((name) => el("button.small", { type: "button", "aria-pressed": "false", "data-testid": `library:${name}`, click: () => void turnTo(name) }, name === "organisms" ? "Organisms" : "Materials"));
  const list = el("ul.library-cards", { "aria-label": "Library", "data-testid": "library" });
  const hint = el("p.hint");
  const element = el("div.library", {}, el("div.library-head", {}, ...kinds, el("span.search", {}, icon("search"), search), hint), list);
  let shown: "organisms" | "materials" = "organisms";
  let materials: Material[] | null = null;
  let dragged: Card | null = null;

  const organismCards = (): Card[] => store.presets.filter(({ name }) => !NOT_THESE.test(name)).map((listed) => ({
    key: listed.name,
    title: listed.title || calledBy(listed.name),
    detail: listed.name,
    picture: listed.picture ? api.galleryPicture(listed.picture) : pictureOf((signal) => api.look(listed.file, signal)),
    use(at): void {
      const ground = at ? view.groundAt(at.x, at.y) : view.groundUnder(view.middle(), 0)?.toArray();
      void addOfSpecies(store, listed, ground ? [round(ground[0], 2), round(ground[2], 2)] : null);
    },
  }));

  const materialCards = (): Card[] => (materials ?? []).map((material) => ({
    key: `${calledBy(material.file)} ${material.name}`,
    title: material.name,
    detail: calledBy(material.file),
    picture: pictureOf((signal) => api.ball(exampleOf(material), 0, signal)),
    use(at): void {
      const under = at ? view.organismAt(at.x, at.y) : null;
      const entries = under === null ? (at ? [] : store.chosen) : store.meant(under);
      if (!entries.length) return say(at ? "Drop it on an organism." : "Select an organism first.");
      if (!applyMaterial(store, material, entries)) say(`${store.preset.nameOf(entries[0]!)} cannot be made of this.`);
      else store.select(entries[0]!);
    },
  }));

  function pictureOf(source: (signal: AbortSignal) => Promise<Blob | null>): HTMLImageElement {
    const picture = el<HTMLImageElement>("img", { alt: "", draggable: false });
    // What has no material of its own to show on a ball is none.
    picture.addEventListener("error", () => (shown === "materials" ? picture.closest("li")?.remove() : picture.replaceWith(el("span.blank", {}, icon("gallery")))));
    looks.want(picture, source);
    return picture;
  }

  const cardOf = (card: Card): HTMLElement => {
    const picture = typeof card.picture === "string" ? el("img", { src: card.picture, alt: "", loading: "lazy", draggable: false }) : card.picture;
    return el("li", {}, el("button.card", { type: "button", draggable: true, "data-testid": `library:${card.key}`, "data-tip": `${card.title} (${card.detail})`, click: () => card.use(null),
      dragstart: (event: DragEvent) => {
        dragged = card;
        event.dataTransfer?.setData(TYPE, card.key);
      },
      dragend: () => (dragged = null) }, picture, el("span", {}, card.title)));
  };

  function show(): void {
    looks.stop();
    kinds.forEach((button, i) => button.setAttribute("aria-pressed", String((i === 0) === (shown === "organisms"))));
    hint.textContent = shown === "organisms" ? "Drag one into the view: the first organism of that preset, as a species." : "Drag one onto an organism, which takes what its kind can have of it.";
    const words = search.value.trim().toLowerCase();
    const cards = (shown === "organisms" ? organismCards() : materialCards()).filter(({ title, detail }) => `${title} ${detail}`.toLowerCase().includes(words));
    list.replaceChildren(...cards.map(cardOf));
  }
  async function turnTo(name: typeof shown): Promise<void> {
    shown = name;
    if (name === "materials") materials ??= await shippedMaterials(store.presets);
    show();
  }

  stage.addEventListener("dragover", (event) => dragged && event.preventDefault());
  stage.addEventListener("drop", (event) => {
    if (!dragged) return;
    event.preventDefault();
    dragged.use({ x: event.clientX, y: event.clientY });
    dragged = null;
  });
  return { element, opened: show, closed: () => looks.stop() };
}
