/** Which species an organism is of: a list with pictures to choose from, and a way to make its properties one's own. */

import * as api from "../api";
import type { Control } from "../controls/control";
import { el } from "../dom";
import { removeAt, setAt } from "../edits";
import { beside } from "../preset";
import { relativeTo, readSpecies, withSpecies } from "../species";
import type { Store } from "../store";
import { dialog, say } from "./dialogs";
import { copyTo, drawPictures } from "./small_pictures";

const ASPECT = 4 / 3;
/** Pictures that were drawn once, by the file of the species. */
const drawn = new Map<string, HTMLCanvasElement>();

/** A file's name without folders and ending, as a person reads it. */
export const calledBy = (file: string): string => file.split("/").at(-1)!.replace(/\.json$/, "").replaceAll("_", " ");

const shipped = (store: Store): api.Listed[] => store.presets.filter((p) => /(^|\/)species\//.test(p.name));

/** May the preset name that file? Others are none that the server reads for it. */
function canName(store: Store, listed: api.Listed): boolean {
  const root = listed.file.slice(0, -(listed.name.length + ".json".length));
  const folder = store.file.slice(0, store.file.lastIndexOf("/") + 1);
  return store.file.startsWith(root) || listed.file.startsWith(folder);
}

export function speciesControl(store: Store, entry: number): Control {
  const name = el<HTMLButtonElement>("button.species-name", { type: "button", "data-testid": "species", "data-tip": "Choose a species: its properties hold where this organism has none of its own", click: () => void choose(store, entry) });
  const own = el<HTMLButtonElement>("button", { type: "button", "data-testid": "make-own", "data-tip": "Writes all that the species says into this preset, which needs the species no more", click: () => {
    makeOwn(store, entry);
    say("Its properties are its own now.");
  } }, "Make it my own");
  const hint = el("p.hint");
  return {
    element: el("div.species", { "data-testid": "row:organism/species" }, name, own, hint),
    refresh(): void {
      const file = store.preset.speciesName(entry);
      const known = Object.keys(store.preset.ofSpecies(entry)).length > 0;
      name.textContent = file ? `Species: ${calledBy(file)}` : "Choose a species …";
      own.hidden = hint.hidden = !file;
      own.disabled = !known;
      hint.textContent = known ? `Marked “sp.”: as ${file} says.` : `${file} is read …`;
    },
  };
}

/** Writes all that its species says into the organism, which names none then. */
function makeOwn(store: Store, entry: number): void {
  const { preset } = store;
  write(store, entry, preset.ofSpecies(entry), beside(store.file, preset.speciesName(entry)));
}

function write(store: Store, entry: number, species: Record<string, unknown>, file: string): void {
  const path = ["organisms", entry];
  store.batch((text) => withSpecies(store.writtenOut(text, [...path, "species"]), path, store.preset.organisms[entry], species, (name) => relativeTo(store.file, beside(file, name))));
}

async function choose(store: Store, entry: number): Promise<void> {
  const list = shipped(store);
  const now = beside(store.file, store.preset.speciesName(entry));
  const over = new AbortController();
  const pictures = list.map(() => el<HTMLCanvasElement>("canvas", { width: 160, height: 120, "aria-hidden": "true" }));
  const chosen = await dialog("Choose a species", (close) => [
    el("ul.species-list", { "aria-label": "Species" }, ...list.map((p, i) =>
      el("li", {}, el("button", { type: "button", "aria-pressed": String(p.file === now), "data-testid": `species:${p.name}`, click: () => close(p.file) }, pictures[i]!, el("strong", {}, calledBy(p.file)), el("small", {}, p.title))))),
    el("div.answers", {}, el("button", { type: "button", click: () => close("none"), hidden: !store.preset.speciesName(entry), "data-testid": "species:none" }, "No species"), el("button.primary", { type: "button", click: () => close(null) }, "Cancel")),
    ...draw(list, pictures, over.signal),
  ], "choose-species");
  over.abort();
  if (chosen === "none") return store.batch((text) => removeAt(store.writtenOut(text, ["organisms", entry, "species"]), ["organisms", entry, "species"]));
  const found = list.find((p) => p.file === chosen);
  if (found) await take(store, entry, found);
}

/** Draws the pictures that there are none of yet, while the list is open. */
function draw(list: api.Listed[], pictures: HTMLCanvasElement[], over: AbortSignal): [] {
  const missing: number[] = [];
  list.forEach((p, i) => {
    const known = drawn.get(p.file);
    if (known) copyTo(pictures[i]!, { from: known, width: known.width, height: known.height });
    else missing.push(i);
  });
  const texts = Promise.all(missing.map(async (i) => ({ text: (await api.preset(list[i]!.file)).text, file: list[i]!.file })));
  void texts.then((docs) => drawPictures(docs, { aspect: ASPECT, shown: { time: 0, solo: null, hide: [] } }, over, (k, cut) => {
    if (typeof cut === "string") return;
    const picture = pictures[missing[k]!]!;
    copyTo(picture, cut);
    drawn.set(docs[k]!.file, picture);
  })).catch(() => undefined);
  return [];
}

/** Another organism, as the first of a preset is: by its name as a species or, where the preset cannot name it, written out. */
export async function addOfSpecies(store: Store, found: api.Listed, at: [number, number] | null): Promise<void> {
  const species = await readSpecies(found.file);
  if (!species) return say(`${found.title || found.name} holds no organism.`, true);
  const creeps = species.kind === "ivy";
  const own = { name: store.freeName(calledBy(found.file)), ...(creeps ? {} : { place: { at: [at ?? [0, 0]] } }) };
  const written = { species: relativeTo(store.file, found.file), ...own };
  if (canName(store, found)) return store.addOrganism(written);
  store.addOrganism(written, (text, path) => withSpecies(text, path, own, species, (name) => relativeTo(store.file, beside(found.file, name))));
}

/**
 * Names the species, or, where the preset cannot, writes what it says. Its kind holds then; of an organism that was of
 * another kind only its places and their number are left.
 */
async function take(store: Store, entry: number, found: api.Listed): Promise<void> {
  const species = await readSpecies(found.file);
  if (!species) return say(`${found.title} could not be read.`, true);
  const path = ["organisms", entry];
  const same = species.kind === store.preset.kindOf(entry);
  const stays = (key: string): boolean => (same ? key !== "kind" : ["species", "place", "count"].includes(key));
  const own = Object.entries(store.preset.organisms[entry] ?? {});
  const named = canName(store, found);
  store.batch((text) => {
    let out = store.writtenOut(text, [...path, "species"]);
    for (const [key] of own) if (!stays(key)) out = removeAt(out, [...path, key]);
    out = setAt(out, [...path, "species"], relativeTo(store.file, found.file));
    return named ? out : withSpecies(out, path, Object.fromEntries(own.filter(([key]) => stays(key))), species, (name) => relativeTo(store.file, beside(found.file, name)));
  });
  if (!named) say(`${found.title} lies in a folder that this preset cannot name: its properties are written out.`);
}
