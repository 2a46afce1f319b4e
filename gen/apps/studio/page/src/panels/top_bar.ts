/** The bar at the top: what is open, undo and redo, save, and what opens all else. */

import { openMenu } from "../controls/menu";
import { el, icon, iconButton } from "../dom";
import type { Store } from "../store";

export interface TopActs {
  gallery(): void;
  save(): void;
  saveAs(): void;
  wall(): void;
  render(): void;
  exports(from: HTMLElement): void;
  seed(): void;
  side(): void;
  theme(): void;
  help(): void;
}

export function topBar(store: Store, acts: TopActs): HTMLElement {
  const undo = iconButton("undo", "Undo (Ctrl+Z)", () => store.undo(), { "data-testid": "undo" });
  const redo = iconButton("redo", "Redo (Ctrl+Shift+Z)", () => store.redo(), { "data-testid": "redo" });
  redo.classList.add("when-roomy");
  const name = el("h1.file", { "data-testid": "file" });
  const mark = el("span.unsaved", { "data-testid": "unsaved", hidden: true }, "unsaved");
  const save = el<HTMLButtonElement>("button", { type: "button", "data-testid": "save", "data-tip": "Save (Ctrl+S)", click: acts.save }, "Save");
  const saveAs = el("button", { type: "button", "data-testid": "save-as-button", "data-tip": "Save under another name (Ctrl+Shift+S)", click: acts.saveAs }, "Save as …");
  const render = el("button.primary", { type: "button", "data-testid": "render", "data-tip": "Render this moment with POV-Ray", click: acts.render }, "Render");
  const exports = el("button", { type: "button", "data-testid": "export", "aria-haspopup": "menu", "data-tip": "Write it for other programs, or save a picture of the view", click: () => acts.exports(exports) }, "Export …");
  const withPreset = [
    el("span.cluster", {}, undo, redo),
    el("span.cluster", {}, save, el("span.cluster.when-roomy", {}, saveAs, exports)),
    el("span.gap"),
    el("span.cluster", {}, el("span.cluster.when-roomy", {}, iconButton("dice", "Another seed", acts.seed, { "data-testid": "seed" }),
      el("button", { type: "button", "data-testid": "variations", "aria-label": "Variations", "data-tip": "A wall of nine variations", click: acts.wall }, icon("wall"), el("span.when-wide", {}, "Variations"))), render),
  ];
  const more = iconButton("more", "More", () => openMenu(more, [
    { label: "Redo", act: () => store.redo(), disabled: !store.canRedo },
    { label: "Save as …", act: acts.saveAs },
    { label: "Export …", act: () => acts.exports(more) },
    { label: "Another seed", act: acts.seed },
    { label: "Variations", act: acts.wall },
    { label: "Light or dark", act: acts.theme },
    { label: "Keys and help", act: acts.help },
  ]), { "aria-haspopup": "menu", "data-testid": "more-acts" });
  more.classList.add("when-narrow");
  const gap = el("span.gap");
  const side = iconButton("side", "Show or hide the side panel", acts.side, { "data-testid": "side" });
  const element = el("header.top-bar", {},
    el("button.brand", { type: "button", "aria-label": "Frond: all presets", "data-testid": "to-gallery", "data-tip": "All presets", click: acts.gallery }, icon("gallery"), el("strong", {}, "Frond")),
    el("span.title", {}, name, mark), ...withPreset, gap,
    el("span.cluster.when-roomy", {}, iconButton("help", "Keys and help (?)", acts.help, { "data-testid": "help" }), iconButton("theme", "Light or dark", acts.theme, { "data-testid": "theme" })), more, side);

  const refresh = (): void => {
    const open = store.isOpen;
    for (const part of [...withPreset, name, side, more]) part.hidden = !open;
    gap.hidden = open;
    name.textContent = store.copy ? `copy of ${store.name}` : store.name;
    name.title = [store.preset.title, store.file].filter(Boolean).join("\n");
    mark.hidden = !store.unsaved;
    undo.disabled = !store.canUndo;
    redo.disabled = !store.canRedo;
    save.disabled = !store.unsaved && !store.copy;
    document.title = open ? `${store.unsaved ? "• " : ""}${store.name} – Frond` : "Frond";
  };
  store.on(["text", "opened", "saved"], refresh);
  refresh();
  return element;
}
