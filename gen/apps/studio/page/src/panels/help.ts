/** Help in the page: the keys that count, and where to read on. */

import * as api from "../api";
import { el } from "../dom";
import { dialog } from "./dialogs";

/** Keys and what they do; those of a group stand together. */
export const KEYS: [group: string, keys: [key: string, does: string][]][] = [
  ["Everywhere", [
    ["?", "this list"],
    ["Ctrl+Z, Ctrl+Shift+Z", "undo, redo"],
    ["Ctrl+S, Ctrl+Shift+S", "save, save as"],
    ["Space", "play, pause"],
    ["/", "filter the properties"],
    ["Tab, Escape", "on to the next thing, close what is open"],
  ]],
  ["Tools", [
    ["V", "select"],
    ["P", "place"],
    ["B", "branches"],
    ["D", "draw"],
    ["K", "paint"],
    ["M", "measure"],
  ]],
  ["View", [
    ["C", "look through the camera"],
    ["F", "frame what is selected"],
    ["1, 3, 7", "from the front, the side, above"],
    ["Home", "back to the preset's camera"],
    ["arrows, with Shift", "turn, move"],
    ["+, -", "nearer, farther"],
    ["Alt and arrows", "move what is selected"],
    ["Enter", "what a click in the middle does"],
  ]],
  ["Lists and values", [
    ["arrows, with Shift", "the next line; one step of a value, ten"],
    ["Alt and arrows", "move an organism in the list"],
    ["Ctrl+G, Ctrl+Shift+G", "group, take out of its group"],
    ["Delete", "remove it"],
  ]],
];

const PAGES: [file: string, title: string][] = [
  ["tutorial.md", "An hour by hand"],
  ["studio.md", "The studio"],
  ["presets.md", "Presets, property by property"],
  ["recipes.md", "Recipes"],
  ["grammars.md", "Grammars"],
  ["trees.md", "Trees"],
  ["edits.md", "Work on branches"],
  ["rendering.md", "Pictures and films"],
  ["export.md", "Export"],
];

/** A link to a page of the documentation, which opens beside this one. */
export const docLink = (file: string, title: string): HTMLElement => el("a", { href: api.docs(file), target: "_blank", rel: "noopener", "data-testid": `doc:${file}` }, title);

/** Says what a place is for, and offers what to do next. */
export const nextStep = (text: string, doc: HTMLElement | null, ...steps: [label: string, act: () => void][]): HTMLElement =>
  el("div.next-step", {}, el("p.hint", {}, text, doc && " ", doc), el("div.cluster", {}, ...steps.map(([label, act], i) => el(`button${i ? "" : ".primary"}`, { type: "button", "data-testid": "next-step", click: act }, label))));

export async function showHelp(): Promise<void> {
  const group = ([title, keys]: (typeof KEYS)[number]): HTMLElement =>
    el("section", {}, el("h3", {}, title), el("dl.keys-list", {}, ...keys.map(([key, does]) => el("div", {}, el("dt", {}, el("kbd", {}, key)), el("dd", {}, does)))));
  await dialog("Keys and help", (close) => [
    el("div.keys-groups", { "data-testid": "keys", role: "region", tabIndex: 0, "aria-label": "Keys" }, ...KEYS.map(group)),
    el("h3", {}, "To read"),
    el("p.doc-links", {}, ...PAGES.map(([file, title]) => docLink(file, title))),
    el("div.answers", {}, el("button.primary", { type: "button", click: () => close(null) }, "Close")),
  ], "help-dialog");
}
