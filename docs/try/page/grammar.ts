/** A grammar that is typed, and what the turtle draws of it beside. */

import { codeArea, type CodeArea } from "../../../gen/apps/studio/page/src/controls/code_area";
import { el, grouped, iconButton, quiet } from "../../../gen/apps/studio/page/src/dom";
import { engine, latest, type Fault } from "./engine";
import { EMPTY, fileOf, formOf, fromFragment, LISTS, placeOf, textOf, toFragment, type Form, type List, type Place } from "./form";
import { glbOf } from "./glb";
import { plantPreset } from "./plant_preset";
import { copyLink, handing, save } from "./savings";
import { shapesOf, type Shapes } from "./shapes";
import { trianglesOf, tubesOf } from "./tubes";
import { viewOn } from "./view";

const FIRST = "bush";
const GROWING = 4000; // milliseconds
const SHOWN_WORD = 4000; // characters

const files = import.meta.glob("../../../presets/grammars/*.json", { eager: true, query: "?raw", import: "default" }) as Record<string, string>;
const examples = new Map(Object.entries(files).map(([path, text]) => [/(\w+)\.json$/.exec(path)![1]!, text]));

let form: Form = { ...EMPTY };

// What is typed

const ABOUT: Record<List, [string, string]> = {
  rules: ["Rules", "One a line: left < predecessor > right : condition ->(weight) successor"],
  interpretation: ["Interpretation", "Rules that only the turtle sees: what a symbol draws"],
  decomposition: ["Decomposition", "Rules that take symbols apart after each step"],
};
const axiom = el<HTMLInputElement>("input.text.code", { type: "text", spellcheck: false, autocomplete: "off", "data-testid": "axiom" });
axiom.addEventListener("input", () => change({ axiom: axiom.value }));
const areas = new Map<List | "others", { area: CodeArea; host: HTMLElement }>();

function field(name: List | "others", label: string, about: string): HTMLElement {
  const area = codeArea(label, (text) => {
    change({ [name]: text });
    fit();
  }, { "data-testid": name });
  const fit = (): void => area.element.style.setProperty("--lines", String(Math.max(name === "rules" ? 5 : 2, area.box.value.split("\n").length) + 1));
  const head = el("summary", { title: about }, label);
  const host = el<HTMLDetailsElement>("details.rules", { open: name === "rules" }, head, area.element);
  areas.set(name, { area, host });
  return host;
}

function slider(label: string, name: "steps" | "angle", max: number, step: number, last: HTMLElement): HTMLElement {
  const range = el<HTMLInputElement>("input.slider", { type: "range", min: "0", max: String(max), step: String(step), "aria-label": label, "data-testid": `${name}-slider` });
  const number = el<HTMLInputElement>("input.number", { type: "number", min: name === "steps" ? "0" : "-360", step: "any", "aria-label": `${label}, as a number`, "data-testid": name });
  for (const input of [range, number])
    input.addEventListener("input", () => {
      if (!Number.isFinite(input.valueAsNumber)) return;
      change({ [name]: input.valueAsNumber });
      if (input === number) reach();
      (input === range ? number : range).value = input.value;
    });
  const reach = (): void => {
    if (name === "steps") range.max = String(Math.max(4, form.steps <= 12 ? Math.ceil(form.steps) + 2 : Math.ceil(form.steps * 1.5)));
    else range.min = form.angle < 0 ? "-180" : "0";
  };
  shownBy.push((opened) => {
    if (opened) reach();
    range.value = number.value = String(form[name]);
  });
  return el("div.row-of", {}, el("span", {}, label), range, number, last);
}
/** Shows the numbers of the form; where it was just opened, their ranges, too. */
const shownBy: ((opened: boolean) => void)[] = [];

/** Shows the steps up to the present one as a film. */
function grow(): void {
  const last = form.steps, began = performance.now();
  const tick = (now: number): void => {
    const share = Math.max(0, now - began) / GROWING;
    change({ steps: share < 1 ? Math.round(last * share * 100) / 100 : last });
    shownBy.forEach((show) => show(false));
    if (form.steps < last) requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
}

const seed = el<HTMLInputElement>("input.number", { type: "number", min: "0", step: "1", "aria-label": "Seed", "data-testid": "seed" });
seed.addEventListener("input", () => Number.isInteger(seed.valueAsNumber) && seed.valueAsNumber >= 0 && change({ seed: seed.valueAsNumber }));
const reseed = el("button", {
  type: "button",
  "data-testid": "reseed",
  click: () => {
    change({ seed: form.seed + 1 });
    seed.value = String(form.seed);
  },
}, "Another seed");

const choice = el<HTMLSelectElement>("select", { "aria-label": "Example", "data-testid": "example" },
  el("option", { value: "", disabled: true }, "Your own"),
  ...[...examples.keys()].map((name) => el("option", { value: name }, name.replace(/_/g, " "))));
choice.addEventListener("change", () => {
  const text = examples.get(choice.value);
  if (text) open(formOf(text), choice.value);
});

// What comes of it

const canvas = el<HTMLCanvasElement>("canvas", { tabIndex: 0, role: "img", "aria-label": "What the turtle draws; the arrow keys turn it", "data-testid": "view" });
const view = viewOn(canvas);
const faults = el("div.faults", { role: "alert", "data-testid": "faults" });
const figures = el("p.figures", { role: "status", "data-testid": "figures" });
const word = el("p.word.code", { tabIndex: 0, "data-testid": "word" });
const words = el<HTMLDetailsElement>("details", {}, el("summary", {}, "The word after whole steps"), word);
words.addEventListener("toggle", () => void showWord());

const NAMES: Record<Place["field"], string> = { rules: "Rules", interpretation: "Interpretation", decomposition: "Decomposition", others: "Other properties", axiom: "Axiom", "": "" };

function line(place: Place): string {
  const where = NAMES[place.field];
  return where ? `${where}${place.field === "axiom" ? "" : `, line ${place.line}`}: ${place.what}` : place.what;
}

function tell(errors: Fault[], notes: Fault[]): void {
  const wrong = errors.map(({ where, what }) => placeOf(form, where, what));
  for (const [name, { area, host }] of areas) {
    const here = wrong.filter((place) => place.field === name);
    area.mark(new Map(here.map((place) => [place.line, place.what])));
    if (here.length) (host as HTMLDetailsElement).open = true;
  }
  axiom.setAttribute("aria-invalid", String(wrong.some((place) => place.field === "axiom")));
  faults.replaceChildren(
    ...wrong.map((place) => el("p", {}, line(place))),
    ...notes.map(({ where, what }) => el("p.note", {}, `Note: ${line(placeOf(form, where, what))}`)));
  canvas.classList.toggle("stale", errors.length > 0);
}

/** What was drawn last. */
let shapes: Shapes | null = null;
async function drawOnce(): Promise<void> {
  const { errors, notes, ...figure } = await engine("draw", textOf(form), form.steps);
  tell(errors, notes ?? []);
  if (errors.length) return;
  shapes = shapesOf(figure);
  view?.show(shapes);
  const counted: [number, string][] = [[figure.segmentColors.length, "segments"], [figure.triangleColors.length, "triangles"], [figure.siteNames.length, "organs"]];
  figures.textContent = counted.filter(([count]) => count).map(([count, what]) => `${grouped(count)} ${what}`).join(", ") || "Nothing is drawn";
}

/** Draws the form as it is now; what is changed while the engine works is drawn next. */
const { draw, busy } = latest(drawOnce, () => void showWord());

async function showWord(): Promise<void> {
  if (!words.open) return;
  const answer = await engine("derive", textOf(form), Math.floor(form.steps));
  if (answer.errors.length) return;
  word.textContent = answer.word.slice(0, SHOWN_WORD) + (answer.word.length > SHOWN_WORD ? " …" : "");
}

// Links and files

const keep = quiet(400, () => panel.isConnected && history.replaceState(null, "", `#${toFragment(form)}`));

function change(changed: Partial<Form>): void {
  form = { ...form, ...changed };
  if ("rules" in changed || "axiom" in changed) choice.value = "";
  handed.refresh();
  keep();
  void draw();
}

function open(next: Form, name: string): void {
  form = next;
  axiom.value = form.axiom;
  seed.value = String(form.seed);
  choice.value = name;
  for (const [list, { area, host }] of areas) {
    area.show(form[list]);
    area.element.style.setProperty("--lines", String(Math.max(list === "rules" ? 5 : 2, form[list].split("\n").length) + 1));
    (host as HTMLDetailsElement).open = list === "rules" || form[list] !== "";
  }
  shownBy.forEach((show) => show(true));
  handed.refresh();
  keep();
  void draw();
}

const nameOf = (): string => `my_${choice.value || "plant"}`;
const handed = handing("grammar", () => ({ name: nameOf(), text: plantPreset(form, nameOf().replace(/_/g, " "), shapes) }));

const button = (label: string, name: string, click: () => unknown): HTMLElement => el("button", { type: "button", "data-testid": name, click }, label);
const savings = el("div.savings", {}, copyLink(keep.now),
  button("Grammar", "save-json", () => save("grammar.json", new Blob([fileOf(form)]))),
  button("SVG", "save-svg", async () => {
    const { errors, svg } = await engine("svg", textOf(form), form.steps);
    if (!errors.length) save("grammar.svg", new Blob([svg]));
  }),
  button("GLB", "save-glb", () => {
    if (!shapes) return;
    save("grammar.glb", glbOf("grammar", [{ ...tubesOf(shapes.segments, 11), name: "branches" }, { ...trianglesOf(shapes.corners), name: "blades", leaf: true }]));
  }),
  button("PNG", "save-png", async () => {
    const picture = await view?.picture();
    if (picture) save("grammar.png", picture);
  }));

const panel = el("main", {},
    el("section.editor", { "aria-label": "Grammar" },
      el("header", {}, el("h1", {}, "Grammars of plants"), choice),
      el("label.row-of", {}, el("span", {}, "Axiom"), axiom),
      ...LISTS.slice(0, 1).map((list) => field(list, ...ABOUT[list])),
      faults,
      slider("Steps", "steps", 10, 0.05, iconButton("play", "Grow", grow, { "data-testid": "grow" })),
      slider("Angle", "angle", 180, 0.5, el("span.unit", {}, "°")),
      el("div.row-of", {}, el("span", {}, "Seed"), reseed, seed, el("span.unit")),
      ...LISTS.slice(1).map((list) => field(list, ...ABOUT[list])),
      field("others", "Other properties", "As in a grammar file: \"width\": 0.1, \"constants\": {\"r\": 0.9}"),
      handed.element,
      words),
    el("section.drawing", { "aria-label": "Drawing" }, canvas,
      view ? null : el("p.fault", {}, "This browser has no WebGL 2, so nothing is drawn; SVG files can be saved."),
      el("footer", {}, figures, savings)));

/** What is shown; "" at first. */
let linked = "";
export const grammarPage = {
  panel,
  /** Opens what a link carries, if it is not shown already; without one, what was shown last. */
  open: (link: string): void => {
    keep();
    if (linked && (!link || link === toFragment(form))) return;
    linked = link || FIRST;
    const carried = link ? fromFragment(link) : null;
    if (carried) open(carried, "");
    else open(formOf(examples.get(FIRST)!), FIRST);
  },
  busy,
};
