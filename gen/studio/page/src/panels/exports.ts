/** What goes out of the studio: the scene for other programs, and the view as a picture. */

import * as api from "../api";
import { openMenu } from "../controls/menu";
import { el } from "../dom";
import type { Store } from "../store";
import type { View } from "../view/view";
import { say } from "./dialogs";

const TYPES: [string, string][] = [
  [".glb", "glTF, for Blender and the web (.glb)"],
  [".obj", "Wavefront (.obj)"],
  [".ply", "Polygons with colours (.ply)"],
  [".vdb", "A volume of the branches (.vdb)"],
  [".inc", "An include for POV-Ray (.inc)"],
];

export function exportMenu(store: Store, view: View, from: HTMLElement): void {
  openMenu(from, [...TYPES.map(([type, label]) => ({ label, act: () => void write(store, type) })), { label: "The view as a picture (.png)", act: () => void saveView(store, view) }]);
}

async function write(store: Store, type: string): Promise<void> {
  say(`Writing ${type} …`);
  try {
    const answer = await api.exported(store.doc, store.time, type);
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
