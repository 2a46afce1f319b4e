/** What goes out of the studio: the scene for other programs, and the view as a picture. */

import * as api from "../api";
import { openMenu } from "../controls/menu";
import { bytes, el, grouped, quiet } from "../dom";
import type { Store } from "../store";
import type { View } from "../view/view";
import { dialog, say } from "./dialogs";

const TYPES: [string, string][] = [
  [".glb", "glTF, for Blender and the web (.glb)"],
  [".obj", "Wavefront (.obj)"],
  [".ply", "Polygons with colours (.ply)"],
  [".vdb", "A volume of the branches (.vdb)"],
  [".inc", "An include for POV-Ray (.inc)"],
];

export function exportMenu(store: Store, view: View, from: HTMLElement): void {
  openMenu(from, [...TYPES.map(([type, label]) => ({ label, act: () => void write(store, { type }) })),
    { label: "Count the triangles first …", tip: "With levels of detail, or with the wind", testid: "export-count", act: () => void orderExport(store) }, { label: "The view as a picture (.png)", act: () => void saveView(store, view) }]);
}

/** Asks how fine it is to be, and says what comes of that before it is written. */
async function orderExport(store: Store): Promise<void> {
  const type = el<HTMLSelectElement>("select", { "aria-label": "Format", "data-testid": "export-type", change: () => count() }, ...TYPES.slice(0, 3).map(([value, label]) => el("option", { value }, label)));
  const detail = el<HTMLInputElement>("input.text", { type: "number", min: "100", step: "1000", value: "250000", "aria-label": "Triangles of one organism, at most about", "data-testid": "export-detail", input: () => count() });
  const levels = el<HTMLInputElement>("input.text", { type: "number", min: "1", max: "6", value: "1", "aria-label": "Levels of detail", "data-testid": "export-levels", input: () => count() });
  const wind = el<HTMLInputElement>("input", { type: "checkbox", "data-testid": "export-wind", change: () => count() });
  const told = el("p.figures", { role: "status", "data-testid": "export-size" }, "Counting …");
  const order = (): api.ExportOrder => ({ type: type.value, detail: Number(detail.value) || 250_000, levels: Number(levels.value) || 1, wind: wind.checked });
  let asked = 0;
  const count = quiet(200, () => void tell());
  async function tell(): Promise<void> {
    const mine = ++asked;
    const isGlb = type.value === ".glb";
    wind.disabled = !isGlb || store.preset.end === 0;
    levels.disabled = !isGlb || (wind.checked && !wind.disabled);
    told.textContent = "Counting …";
    const size = await api.exportSize(store.doc, store.time, order()).catch((error: Error) => error.message);
    if (mine === asked) told.textContent = typeof size === "string" ? size : sizeSaid(size);
  }
  const line = (label: string, control: HTMLElement): HTMLElement => el("label.field", {}, el("span", {}, label), control);
  const chosen = dialog("Export", (close) => [
    line("Format", type), line("Triangles of one organism, at most about", detail), line("Levels of detail, each a quarter of the one before", levels),
    el("label.line", {}, wind, el("span", {}, "As it sways and grows over the film (glTF)")), told,
    el("div.answers", {}, el("button", { type: "button", click: () => close(null) }, "Cancel"), el("button.primary", { type: "button", "data-testid": "export-write", click: () => close("write") }, "Export")),
  ], "export-order");
  void tell();
  if ((await chosen) === "write") void write(store, order());
}

function sizeSaid({ triangles, bytes: size, sown }: api.ExportSize): string {
  const sum = triangles.reduce((a, b) => a + b, 0);
  const levels = triangles.length > 1 ? ` (${triangles.map(grouped).join(", ")})` : "";
  return `About ${grouped(sum)} triangles${levels} and ${bytes(size)}.${sown ? ` The ${grouped(sown)} plants that are sown come besides.` : ""}`;
}

async function write(store: Store, order: api.ExportOrder): Promise<void> {
  say(`Writing ${order.type} …`);
  try {
    const answer = await api.exported(store.doc, store.time, order);
    if (Array.isArray(answer)) say(answer.map((f) => f.text).join("; "), true);
    else say(`Written: ${answer.file}`);
  } catch (error) {
    say((error as Error).message, true);
  }
}

async function saveView(store: Store, view: View): Promise<void> {
  const address = URL.createObjectURL(await view.picture());
  el<HTMLAnchorElement>("a", { href: address, download: `${store.name.replace(/\.json$/, "")}.png` }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
