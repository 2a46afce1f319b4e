/** A tree that grows for light: its species, age, seed and the time of the year, and the tree beside. */

import { el, grouped, iconButton, quiet } from "../../../gen/apps/studio/page/src/dom";
import { removeAt, setAt } from "../../../gen/apps/studio/page/src/edits";
import { Preset } from "../../../gen/apps/studio/page/src/preset";
import { INTERNODES, latest, treeOf, type Tree } from "./engine";
import { glbOf } from "./glb";
import { copyLink, handing, save } from "./savings";
import { treeParts } from "./tree_parts";
import { treeViewOn } from "./tree_view";

const FIRST = "oak";
const GROWING = 6000; // milliseconds
const MONTHS = ["January", "February", "March", "April", "May", "June", "July", "August", "September", "October", "November", "December"];

interface Choice {
  species: string;
  years: number;
  seed: number;
  /** Of the year, 0..1. */
  time: number;
}

interface Species {
  text: string;
  years: number;
  seed: number;
}

/** A preset's first organism without what stands around it, or null where that is no tree, or another one grows by rules of its own. */
function aloneIn(text: string): Species | null {
  const { own, organisms: [first, ...others] } = new Preset(text);
  if (first?.kind !== "tree" || others.some(({ kind }) => kind === "tree")) return null;
  const alone = others.reduceRight<string>((rest, _, i) => removeAt(rest, ["organisms", i + 1]), text);
  return { text: removeAt(alone, ["scene", "far", "trees"]), years: Number(first.years ?? 1), seed: Number(own.seed ?? 1) };
}
const files = import.meta.glob("../../../presets/trees/*.json", { eager: true, query: "?raw", import: "default" }) as Record<string, string>;
const species = new Map<string, Species>(Object.entries(files)
  .map(([path, text]) => [/(\w+)\.json$/.exec(path)![1]!, aloneIn(text)] as const)
  .filter((one): one is [string, Species] => one[1] !== null));

const begin = (name: string): Choice => ({ species: name, years: species.get(name)!.years, seed: species.get(name)!.seed, time: 0.5 });
let choice: Choice = begin(FIRST);
/** The last that was grown, and milliseconds that its growing took. */
let tree: Tree | null = null, took = 0;

// What is chosen

const kind = el<HTMLSelectElement>("select", { "aria-label": "Species", "data-testid": "species" },
  ...[...species.keys()].map((name) => el("option", { value: name }, name.replace(/_/g, " "))));
kind.addEventListener("change", () => show({ ...begin(kind.value), time: choice.time }));

const years = el<HTMLInputElement>("input.slider", { type: "range", min: "1", step: "1", "aria-label": "Years", "data-testid": "years-slider" });
const age = el<HTMLInputElement>("input.number", { type: "number", min: "1", step: "1", "aria-label": "Years, as a number", "data-testid": "years" });
for (const input of [years, age]) {
  input.addEventListener("input", () => input.valueAsNumber >= 1 && change({ years: Math.round(input.valueAsNumber) }, input));
  input.addEventListener("change", () => fill());
}

const time = el<HTMLInputElement>("input.slider", { type: "range", min: "0", max: "1", step: "0.01", "aria-label": "Time of the year", "data-testid": "time" });
time.addEventListener("input", () => change({ time: time.valueAsNumber }, time));
const month = el("span.unit.month", { "data-testid": "month" });

const seed = el<HTMLInputElement>("input.number", { type: "number", min: "0", step: "1", "aria-label": "Seed", "data-testid": "tree-seed" });
seed.addEventListener("input", () => Number.isSafeInteger(seed.valueAsNumber) && seed.valueAsNumber >= 0 && change({ seed: seed.valueAsNumber }, seed));
const reseed = el("button", { type: "button", "data-testid": "tree-reseed", click: () => change({ seed: choice.seed + 1 }) }, "Another seed");

/** Shows what is chosen, but not in the field that is typed in. */
function fill(typing?: HTMLInputElement): void {
  const put = (input: HTMLInputElement, value: number): void => {
    if (input !== typing) input.value = String(value);
  };
  kind.value = choice.species;
  handed.refresh();
  years.max = age.max = String(tree ? tree.cycles.length - 1 : species.get(choice.species)!.years);
  put(years, choice.years), put(age, choice.years);
  put(time, choice.time), put(seed, choice.seed);
  month.textContent = MONTHS[Math.min(11, Math.floor(choice.time * 12))]!;
  time.setAttribute("aria-valuetext", month.textContent);
}

/** Shows its life up to the present age as a film, each cycle of growth in the same time. */
async function grow(): Promise<void> {
  const { years: last, species: grown, seed: from } = choice, cycles = tree?.cycles;
  if (!cycles || busy()) return;
  const ages = [...cycles.keys()].filter((year) => year > 0 && year < last && cycles[year]! > cycles[year - 1]!);
  const began = performance.now();
  for (let share = 0; share < 1 && choice.species === grown && choice.seed === from;) {
    share = (performance.now() - began) / GROWING;
    choice = { ...choice, years: ages[Math.floor(share * ages.length)] ?? last };
    fill();
    await draw();
    await new Promise(requestAnimationFrame);
  }
}

// What comes of it

const canvas = el<HTMLCanvasElement>("canvas", { tabIndex: 0, role: "img", "aria-label": "The tree; the arrow keys turn it, plus and minus come nearer and go back", "data-testid": "tree-view" });
const view = treeViewOn(canvas);
const faults = el("div.faults", { role: "alert", "data-testid": "tree-faults" });
const figures = el("p.figures", { role: "status", "data-testid": "tree-figures" });
const note = el("p.hint", { "data-testid": "tree-note" });

let shown = "";
async function drawOnce(): Promise<void> {
  const asked = choice, { text } = species.get(asked.species)!, key = `${asked.species} ${asked.seed}`;
  const fresh = key !== shown, began = performance.now();
  if (fresh) figures.textContent = "Growing …";
  canvas.classList.toggle("stale", fresh);
  const answer = await treeOf(text, asked.seed, asked.years, asked.time);
  faults.replaceChildren(...answer.errors.map(({ what }) => el("p", {}, what)));
  if (answer.errors.length) {
    figures.textContent = "";
    return;
  }
  if (fresh) took = performance.now() - began;
  tree = answer;
  shown = key;
  canvas.classList.remove("stale");
  const oldest = answer.cycles.length - 1;
  if (choice.species === asked.species && choice.seed === asked.seed) choice = { ...choice, years: Math.min(choice.years, oldest) };
  fill(document.activeElement instanceof HTMLInputElement ? document.activeElement : undefined);
  view?.show(answer);
  const stem = answer.stem > 0 ? `, stem of ${Math.round(answer.stem * 100)} cm` : "";
  figures.textContent = `${answer.height.toFixed(1)} m high${stem}, ${grouped(answer.internodes)} internodes; grown in ${(took / 1000).toFixed(1)} s`;
  note.textContent = oldest < species.get(asked.species)!.years ? `It is followed for ${oldest} years, until ${grouped(INTERNODES)} internodes would stand.` : "";
}
/** Draws what is chosen now; what is changed while the engine works is drawn next. */
const { draw, busy } = latest(drawOnce);

// Links and files

const fragment = (): string => new URLSearchParams({ tree: choice.species, years: String(choice.years), seed: String(choice.seed), season: String(choice.time) }).toString();
const keep = quiet(400, () => panel.isConnected && history.replaceState(null, "", `#${fragment()}`));

function change(changed: Partial<Choice>, typing?: HTMLInputElement): void {
  choice = { ...choice, ...changed };
  fill(typing);
  keep();
  void draw();
}
function show(next: Choice): void {
  tree = null;
  change(next);
}

const fileName = (): string => `my_${choice.species}`;
/** The preset of the species, of that age and seed at that time of the year. */
function presetText(): string {
  const { text, years: usual } = species.get(choice.species)!;
  let aged = setAt(setAt(removeAt(text, ["$schema"]), ["seed"], choice.seed), ["organisms", 0, "years"], choice.years);
  // Its camera looks at a tree of the usual age.
  if (choice.years !== usual) aged = setAt(aged, ["scene", "camera", "fit"], ["all"]);
  return choice.time === 0.5 && !/"season":/.test(text) ? aged : setAt(aged, ["organisms", 0, "season", "at"], choice.time);
}
const handed = handing("tree", () => ({ name: fileName(), text: presetText() }));

const savings = el("div.savings", {}, copyLink(keep.now),
  el("button", { type: "button", "data-testid": "tree-glb", click: () => {
    if (tree) save(`${fileName()}.glb`, glbOf(choice.species, treeParts(tree)));
  } }, "GLB"),
  el("button", { type: "button", "data-testid": "tree-png", click: async () => {
    const picture = await view?.picture();
    if (picture) save("tree.png", picture);
  } }, "PNG"));

const panel = el("main", {},
  el("section.editor", { "aria-label": "Tree" },
    el("header", {}, el("h1", {}, "Trees that grow for light"), kind),
    el("p.hint", {}, "Each bud grows as far as the light allows that the leaves above leave it; what is shaded dies and falls. Nothing of the outline is drawn by hand."),
    el("div.row-of", {}, el("span", {}, "Years"), years, age, iconButton("play", "Grow", grow, { "data-testid": "tree-grow" })),
    el("div.row-of", {}, el("span", {}, "Season"), time, month),
    el("div.row-of", {}, el("span", {}, "Seed"), reseed, seed, el("span.unit")),
    faults,
    note,
    handed.element),
  el("section.drawing.outdoors", { "aria-label": "The tree" }, canvas,
    view ? null : el("p.fault", {}, "This browser has no WebGL 2, so nothing is drawn."),
    el("footer", {}, figures, savings)));

/** Whether a link is one of these. */
export const isTreeLink = (link: string): boolean => link.startsWith("tree=");

/** The choice of a link; what it does not say or says wrongly is as at the beginning. */
function fromLink(link: string): Choice {
  const said = new URLSearchParams(link), name = said.get("tree") ?? "";
  const first = begin(species.has(name) ? name : FIRST);
  const number = (key: string, most: number, otherwise: number): number => {
    const value = Number(said.get(key) ?? NaN);
    return value >= 0 && value <= most ? value : otherwise;
  };
  return {
    ...first,
    years: Math.max(1, Math.round(number("years", first.years, first.years))),
    seed: Math.round(number("seed", Number.MAX_SAFE_INTEGER, first.seed)),
    time: number("season", 1, first.time),
  };
}

export const treePage = {
  panel,
  /** Opens what a link carries, if it is not shown already; without one, what was shown last. */
  open: (link: string): void => {
    if (link !== "tree=" && link !== fragment()) show(fromLink(link));
    else if (!tree) show(choice);
    else keep();
  },
  busy,
};
