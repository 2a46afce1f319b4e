/** Adding an organism: of a kind, from another preset, or a file of a mesh. */

import * as api from "../api";
import { el, icon } from "../dom";
import { sliceAt } from "../edits";
import { Looks } from "../looks";
import { getAt } from "../pointer";
import { LIFELESS, Preset } from "../preset";
import { spelled } from "../schema";
import type { Store } from "../store";
import { parse } from "jsonc-parser";
import { dialog, say } from "./dialogs";

/** What a kind needs to be something to look at. */
const STARTS: Record<string, object> = {
  plant: { height: 1, grammar: { axiom: "X", steps: 5, angle: 25, rules: ["X -> F[+X][-X]FX", "F -> FF"] }, thickness: { from: "pipe", radius: 0.012 } },
  coral: { height: 0.6 },
  colonized: { envelope: {} },
};

/** A preset whose picture shows a kind. A kind without one has a sign in its place. */
const EXAMPLES: Record<string, string> = {
  coral: "staghorn", massive: "species/corals/brain", columnar: "species/corals/pillar", foliose: "species/corals/lettuce_coral", table: "species/corals/table_coral",
  encrusting: "species/corals/encrusting_coral", tube: "species/corals/tube_sponge", mushroom: "species/corals/mushroom_coral", fan: "fan", shell: "shells", school: "reef/fishes",
  plant: "garden/bush", tree: "trees/oak", weber_penn: "aspen", colonized: "heart_tree", ivy: "ivy/brick_wall", rock: "garden/rocks", wall: "garden/walled", column: "ivy/column",
  mesh: "ivy/any_mesh", bridge: "garden/bridge", vase: "garden/vases", trellis: "garden/espalier",
};
const OF_THE_SEA = new Set(["coral", "massive", "columnar", "foliose", "table", "encrusting", "tube", "mushroom", "fan", "shell", "school"]);

/** The names of files of meshes end so, as a rule; and those of the files that these name. */
const MESHES = ".obj,.ply,.stl,.glb";
const BESIDE = ".mtl,.png,.jpg,.jpeg,.webp";
const LARGEST = 64e6; // bytes

/** What lives in the setting first, then what stands in any, then what lives elsewhere. */
export function inOrderOf<T extends { value: string }>(setting: string, kinds: T[]): T[] {
  const rank = ({ value }: T): number => (LIFELESS.has(value) ? 1 : OF_THE_SEA.has(value) === (setting === "underwater") ? 0 : 2);
  return [...kinds].sort((a, b) => rank(a) - rank(b));
}

export async function addOrganism(store: Store): Promise<void> {
  let files: File[] = [];
  const looks = new Looks();
  const setting = String(getAt(store.preset.whole, ["scene", "setting"]) ?? "");
  const pictureOf = (kind: string): HTMLElement => {
    const listed = store.presets.find(({ name }) => name === EXAMPLES[kind]);
    const blank = (): HTMLElement => el("span.blank", { "aria-hidden": "true" }, icon("gallery"));
    if (!listed) return blank();
    const picture = el<HTMLImageElement>("img", { alt: "", loading: "lazy" });
    picture.addEventListener("error", () => picture.replaceWith(blank()));
    if (listed.picture) picture.src = api.galleryPicture(listed.picture);
    else looks.want(picture, (signal) => api.look(listed.file, signal));
    return picture;
  };
  const chosen = await dialog("Add an organism", (close) => {
    const kinds = inOrderOf(setting, store.schema.kinds).map(({ value, doc }, i) =>
      el("li", {}, el("button.choice", { type: "button", autofocus: i === 0, "data-testid": `add:${value}`, click: () => close(`kind ${value}`) }, pictureOf(value), el("strong", {}, spelled(value)), el("span", {}, doc))),
    );
    const input = el<HTMLInputElement>("input", { type: "file", multiple: true, accept: `${MESHES},${BESIDE}`, "aria-label": "Files of a mesh", "data-testid": "add-mesh", change: () => {
      files = [...(input.files ?? [])];
      if (files.length) close("file");
    } });
    return [
      el("h3", {}, "Of a kind"),
      el("ul.choices", { tabIndex: 0, "aria-label": "Kinds" }, ...kinds),
      el("h3", {}, "From another preset"),
      fromPreset(store, close),
      el("h3", {}, "From a mesh"),
      el("div.line", {}, input, el("span.hint", {}, "OBJ with its MTL and pictures, PLY, STL or GLB; or drop them on the page")),
      el("div.answers", {}, el("button", { type: "button", click: () => close(null) }, "Cancel")),
    ];
  }, "add");
  looks.stop();
  if (!chosen) return;
  if (chosen === "file") return addMeshes(store, files);
  const [what, ...rest] = chosen.split(" ");
  if (what === "kind") store.addOrganism(ofKind(store, rest[0]!));
  else store.addOrganism(parse(rest.join(" ")));
}

/** One of a kind that is something to look at. */
export function ofKind(store: Store, kind: string): object {
  return { kind, name: store.freeName(spelled(kind)), ...(kind === "ivy" ? {} : { place: { at: [[0, 0]] } }), ...STARTS[kind] };
}

/** A list of presets, then of the organisms of the one chosen. */
function fromPreset(store: Store, close: (answer: string) => void): HTMLElement {
  const files = el<HTMLSelectElement>("select", { "aria-label": "Preset", "data-testid": "add-from" }, el("option", { value: "" }, "choose a preset"),
    ...store.presets.map((p) => el("option", { value: p.file }, p.title || p.file)));
  const organisms = el<HTMLSelectElement>("select", { "aria-label": "Organism", disabled: true, "data-testid": "add-which" });
  const add = el<HTMLButtonElement>("button", { type: "button", disabled: true }, "Add");
  let preset: Preset | null = null;
  files.addEventListener("change", () => void read());
  async function read(): Promise<void> {
    try {
      preset = new Preset((await api.preset(files.value)).text);
    } catch (error) {
      return say((error as Error).message, true);
    }
    organisms.replaceChildren(...preset.organisms.map((_, i) => el("option", { value: i }, preset!.nameOf(i))));
    organisms.disabled = add.disabled = !preset.organisms.length;
  }
  add.addEventListener("click", () => {
    const entry = Number(organisms.value);
    const shared = preset && Object.keys(preset.defaults).length > 0;
    // What the other preset says for all goes with it.
    const text = shared ? JSON.stringify(preset!.organism(entry)) : preset && sliceAt(preset.text, ["organisms", entry]);
    if (text) close(`json ${text}`);
  });
  return el("div.line", {}, files, organisms, add);
}

/** Lets the meshes among some files stand in the scene, side by side; the others are what these may name. */
async function addMeshes(store: Store, files: File[], [x, z]: [number, number] = [0, 0]): Promise<void> {
  if (!store.isOpen) return say("Open a preset first, then drop the file on it.", true);
  const beside = files.filter(({ name }) => BESIDE.split(",").some((end) => name.toLowerCase().endsWith(end)));
  const meshes = files.filter((file) => !beside.includes(file));
  if (!meshes.length && files.length) return say(`${files[0]!.name} is no mesh: drop the mesh that names it together with it.`, true);
  for (const [i, file] of meshes.entries()) {
    if (files.reduce((sum, { size }) => sum + size, 0) > LARGEST) return say(`${file.name} and what came with it are larger than ${LARGEST / 1e6} MB.`, true);
    try {
      const answer = await api.mesh(file, beside, store.file);
      store.addOrganism({ kind: "mesh", name: file.name.replace(/\.[^.]*$/, ""), file: answer.file, place: { at: [[Number((x + i).toFixed(2)), z]], size_variation: 0, turn_variation: 0, lean: 0 } });
      say(`${file.name} stands in the scene. Ivy climbs it.`);
    } catch (error) {
      say((error as Error).message, true);
    }
  }
}

/** Files that are dropped anywhere on the page; on the ground they stand where they fell. */
export function takeDrops(store: Store, groundAt: (x: number, y: number) => [number, number, number] | null): void {
  const over = (event: DragEvent): void => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    document.body.classList.toggle("dropping", event.type === "dragover");
  };
  addEventListener("dragover", over);
  addEventListener("dragleave", over);
  addEventListener("drop", (event) => {
    over(event);
    const [x, , z] = groundAt(event.clientX, event.clientY) ?? [0, 0, 0];
    void addMeshes(store, [...(event.dataTransfer?.files ?? [])], [Number(x.toFixed(2)), Number(z.toFixed(2))]);
  });
}

