/** Views with names, which the preset keeps: go there, add the one that is looked from, rename, remove; and keys of the camera. */

import { el, iconButton } from "../dom";
import { getAt, isObject, type Path } from "../pointer";
import { rounded } from "../rounding";
import type { Store } from "../store";
import type { Vec3 } from "../view/header";
import type { View } from "../view/view";
import { setCamera } from "./set_camera";

interface NamedView {
  name: string;
  at: Vec3;
  to: Vec3;
}

const VIEWS: Path = ["scene", "views"];

/** Those of a preset; what is none yet, while it is written, is passed over. */
export function viewsOf(whole: unknown): (NamedView | null)[] {
  const list = getAt(whole, VIEWS);
  if (!Array.isArray(list)) return [];
  const point = (value: unknown): value is Vec3 => Array.isArray(value) && value.length === 3 && value.every((x) => typeof x === "number");
  return list.map((view) => (isObject(view) && typeof view.name === "string" && point(view.at) && point(view.to) ? { name: view.name, at: view.at, to: view.to } : null));
}

export function viewsPanel(store: Store, view: View): HTMLElement {
  const list = el("ul.views", { "aria-label": "Views" });
  const add = el("button.small", { type: "button", "data-testid": "add-view", click: () => addView() }, "Keep this view");
  const key = el("button.small", { type: "button", "data-testid": "key-view", "data-tip": "The camera is here at the time shown, and moves on to its next key", click: () => {
    const { at, to } = view.eye();
    setCamera(store, at, to, true);
  } }, "Key from this view");
  let shown = "[]";

  const addView = (): void => {
    const { at, to } = view.eye();
    const count = viewsOf(store.preset.whole).length;
    const angle = store.scene.header?.camera.angle ?? 45;
    store.set([...VIEWS, count], { name: `view ${count + 1}`, at: rounded(at), to: rounded(to), angle: Number(angle.toFixed(2)) });
    list.querySelectorAll<HTMLInputElement>("input").item(count)?.select();
  };
  const row = (named: NamedView | null, i: number): HTMLElement => {
    const name = el<HTMLInputElement>("input", { type: "text", value: named?.name ?? "", "aria-label": `Name of view ${i + 1}`, "data-testid": `view-name:${i}`, change: () => store.set([...VIEWS, i, "name"], name.value) });
    return el("li", {},
      el("button.small", { type: "button", disabled: !named, "aria-label": `Go to ${named?.name ?? "it"}`, "data-testid": `go-view:${i}`, click: () => named && view.goTo(named.at, named.to) }, "Go"),
      name,
      iconButton("remove", `Remove ${named?.name ?? "it"}`, () => {
        store.remove([...VIEWS, i]);
        add.focus();
      }, { "data-testid": `remove-view:${i}` }));
  };
  const show = (): void => {
    const views = viewsOf(store.preset.whole);
    const now = JSON.stringify(views);
    if (now === shown) return;
    shown = now;
    list.replaceChildren(...views.map(row));
  };
  store.on(["text", "opened"], show);
  show();
  return el("div.views-panel", { role: "group", "aria-label": "Views and camera" }, add, key, list);
}
