/** What the pointer does in the view: select, work on branches, draw, measure. */

import { el, icon } from "../dom";
import type { Store } from "../store";
import { Branches } from "../tools/branches";
import { Draw } from "../tools/draw";
import { Measure } from "../tools/measure";
import { Paint } from "../tools/paint";
import { PlaceTool } from "../tools/place";
import type { View } from "../view/view";

export type ToolName = "select" | "place" | "branches" | "draw" | "paint" | "measure";
const TOOLS: [ToolName, string, string][] = [
  ["select", "Select", "Click to select, drag what is movable (V)"],
  ["place", "Place", "Move, turn, scale, copy and scatter organisms (P)"],
  ["branches", "Branches", "Cut, bend and strengthen branches (B)"],
  ["draw", "Draw", "Draw guides, ways, paths and beds (D)"],
  ["paint", "Paint", "Paint where things grow: what is sown, ivy, moss, grass, snow (K)"],
  ["measure", "Measure", "Metres between two places (M)"],
];

export interface Tools {
  element: HTMLElement;
  choose(name: ToolName): void;
}

export function tools(store: Store, view: View): Tools {
  const made = { place: new PlaceTool(store, view), branches: new Branches(store, view), draw: new Draw(store, view), paint: new Paint(store, view), measure: new Measure(store, view) };
  let now: ToolName = "select";
  const buttons = TOOLS.map(([name, label, tip]) => el("button.tool", { type: "button", "data-tip": tip, "data-testid": `tool:${name}`, "aria-pressed": String(name === now), click: () => choose(name) }, icon(name), el("span", {}, label)));
  const options = el("div.tool-panel", { hidden: true });
  const element = el("div.tools", {}, el("div.rail", { role: "group", "aria-label": "Tools" }, ...buttons), options);

  function choose(name: ToolName): void {
    if (now === "paint") made.paint.leave();
    now = name;
    const tool = name === "select" ? null : made[name];
    TOOLS.forEach(([other], i) => buttons[i]!.setAttribute("aria-pressed", String(other === name)));
    options.hidden = tool === null;
    options.replaceChildren(...(tool ? [tool.options] : []));
    tool?.refresh();
    view.use(tool);
  }
  const refresh = (): void => {
    if (now !== "select") made[now].refresh();
  };
  store.on(["selected", "scene"], refresh);
  // The others wait for the picture.
  store.on("text", () => now === "place" && made.place.refresh());
  store.on("opened", () => choose("select"));
  view.onKey((event) => now !== "select" && made[now].key(event));
  return { element, choose };
}
