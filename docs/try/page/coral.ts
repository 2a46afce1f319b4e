/** A coral: its species, the properties that shape it, its preset as text, and the coral beside. */

import { codeArea } from "../../../gen/apps/studio/page/src/controls/code_area";
import { el, iconButton, quiet } from "../../../gen/apps/studio/page/src/dom";
import { removeAt, setAt } from "../../../gen/apps/studio/page/src/edits";
import type { Path } from "../../../gen/apps/studio/page/src/pointer";
import { Preset } from "../../../gen/apps/studio/page/src/preset";
import { coralFields, kinds } from "./coral_fields";
import { coralViewOn, meshOf } from "./coral_view";
import { coralOf, latest, type Coral } from "./engine";
import { glbOf } from "./glb";
import { copyLink, handing, packed, save, unpacked } from "./savings";

const FIRST = "cauliflower";
const GROWING = 5000; // milliseconds
/** What takes longer than so many milliseconds is drawn roughly first. */
const SLOW = 700, ROUGH = 350;

/** The presets that grow one coral of a kind that the engine has. */
const files = import.meta.glob("../../../presets/species/corals/*.json", { eager: true, query: "?raw", import: "default" }) as Record<string, string>;
const species = new Map<string, string>(Object.entries(files)
  .map(([path, text]): [string, string] => [/(\w+)\.json$/.exec(path)![1]!, removeAt(text, ["$schema"])])
  .filter(([, text]) => {
    const preset = new Preset(text);
    return preset.organisms.length === 1 && kinds.includes(preset.kindOf(0)) && !preset.organisms[0]!.edits;
  }));

let name = FIRST, text = species.get(FIRST)!, grown = 1;
let coral: Coral | null = null;
/** Milliseconds that all of it took to grow. */
let took = 0;
/** Of the time that growing takes: below 1 a rough version. */
let share = 1;

// What is chosen

const kind = el<HTMLSelectElement>("select", { "aria-label": "Coral", "data-testid": "coral" },
  ...[...species.keys()].map((each) => el("option", { value: each }, each.replace(/_/g, " "))));
kind.addEventListener("change", () => open(kind.value, species.get(kind.value)!));

const fields = coralFields((path, value) => edit(["organisms", 0, ...path], value));

const seed = el<HTMLInputElement>("input.number", { type: "number", min: "0", step: "1", "aria-label": "Seed", "data-testid": "coral-seed" });
seed.addEventListener("input", () => Number.isSafeInteger(seed.valueAsNumber) && seed.valueAsNumber >= 0 && edit(["seed"], seed.valueAsNumber));
const reseed = el("button", { type: "button", "data-testid": "coral-reseed", click: () => edit(["seed"], seedOf() + 1) }, "Another seed");
const seedOf = (): number => Number(new Preset(text).own.seed ?? 1) || 0;

const growth = el<HTMLInputElement>("input.slider", { type: "range", min: "0.02", max: "1", step: "0.01", "aria-label": "Growth", "data-testid": "coral-growth" });
growth.addEventListener("input", () => {
  grown = growth.valueAsNumber;
  fill();
  void draw();
});
const percent = el("span.unit.of-growth", {});

const area = codeArea("Preset", (typed) => change(typed), { "data-testid": "coral-text" });
const preset = el<HTMLDetailsElement>("details", {}, el("summary", {}, "Preset"), area.element);
const handed = handing("coral", () => ({ name: fileName(), text }));
const fileName = (): string => `my_${name}`;

function fill(): void {
  const read = new Preset(text), at = read.organism(0);
  kind.value = name;
  growth.value = String(grown);
  percent.textContent = `${Math.round(100 * grown)} %`;
  if (document.activeElement !== seed) seed.value = String(seedOf());
  if (kinds.includes(String(at.kind))) fields.show(String(at.kind), at);
  area.show(text);
  area.element.style.setProperty("--lines", String(Math.min(28, text.split("\n").length + 1)));
  handed.refresh();
}

/** Shows its growth as a film. */
async function grow(): Promise<void> {
  if (busy() || !coral) return;
  const began = performance.now(), of = text;
  grown = 0.02;
  while (grown < 1 && of === text) {
    grown = Math.min(1, Math.max(0.02, (performance.now() - began) / GROWING));
    fill();
    await draw();
    await new Promise(requestAnimationFrame);
  }
}

// What comes of it

const canvas = el<HTMLCanvasElement>("canvas", { tabIndex: 0, role: "img", "aria-label": "The coral; the arrow keys turn it, plus and minus come nearer and go back", "data-testid": "coral-view" });
const view = coralViewOn(canvas);
const faults = el("div.faults", { role: "alert", "data-testid": "coral-faults" });
const figures = el("p.figures", { role: "status", "data-testid": "coral-figures" });

/** Errors as the program prints them, and where they are in the text. */
function tell({ errors, notes }: Coral): void {
  const line = ({ where, what }: { where: string; what: string }): string => (where ? `${where}: ${what}` : what);
  area.mark(new Map(errors.flatMap(({ where, what }) => {
    const at = /\.json:(\d+):\d+/.exec(where);
    return at ? [[Number(at[1]), what] as const] : [];
  })));
  faults.replaceChildren(...errors.map((one) => el("p", {}, line(one))), ...(notes ?? []).map((one) => el("p.note", {}, `Note: ${line(one)}`)));
  canvas.classList.toggle("stale", errors.length > 0);
}

const centimetres = (metres: number): string => (metres < 0.1 ? (100 * metres).toFixed(1) : String(Math.round(100 * metres)));

let drawn = "";
async function drawOnce(): Promise<void> {
  const asked = text, rough = share, key = `${rough} ${asked}`, began = performance.now();
  if (key !== drawn && rough === 1) figures.textContent = "Growing …";
  const answer = await coralOf(asked, `${fileName()}.json`, rough, grown);
  tell(answer);
  if (answer.errors.length) {
    figures.textContent = "";
    return;
  }
  if (key !== drawn && rough === 1) took = performance.now() - began;
  drawn = key;
  coral = answer;
  view?.show(answer);
  const [wide, high, deep] = answer.size.map(centimetres);
  figures.textContent = `${wide} × ${deep} cm, ${high} cm high${rough < 1 ? "; roughly, for now" : `; grown in ${(took / 1000).toFixed(1)} s`}`;
}
/** Draws the coral as it is now; what is changed while the engine works is drawn next. */
const { draw, busy } = latest(drawOnce);
/** Once nothing is changed any more, all of it. */
const settle = quiet(450, () => {
  share = 1;
  void draw();
});

// Links and files

const fragment = (): string => new URLSearchParams(text === species.get(name) ? { coral: name } : { coral: name, preset: packed(text) }).toString();
const keep = quiet(400, () => panel.isConnected && history.replaceState(null, "", `#${fragment()}`));

function change(next: string): void {
  text = next;
  share = took > SLOW ? Math.max(1 / 16, ROUGH / took) : 1;
  if (share < 1) settle();
  fill();
  keep();
  void draw();
}
function edit(path: Path, value: unknown): void {
  if (new Preset(text).syntax.length) return;  // the text is being typed
  change(setAt(text, path, value));
}
function open(next: string, its: string): void {
  name = next;
  grown = 1;
  took = 0;
  change(its);
}

const button = (label: string, test: string, click: () => unknown): HTMLElement => el("button", { type: "button", "data-testid": test, click }, label);
const savings = el("div.savings", {}, copyLink(keep.now),
  button("GLB", "coral-glb", () => {
    if (!coral) return;
    const mesh = meshOf(coral), second = coral.second;
    // What shows of the hollows from afar.
    const colors = mesh.colors.map((c, i) => {
      const ridge = coral!.matter === "valleys" ? mesh.skin[3 * Math.floor(i / 3)]! : 0.75;
      return c * ridge + second[i % 3]! * (1 - ridge);
    });
    save(`${fileName()}.glb`, glbOf(name, [{ ...mesh, colors, name, gloss: 0.4 }]));
  }),
  button("PNG", "coral-png", async () => {
    const picture = await view?.picture();
    if (picture) save(`${fileName()}.png`, picture);
  }));

const panel = el("main", {},
  el("section.editor.coral", { "aria-label": "Coral" },
    el("header", {}, el("h1", {}, "Corals"), kind),
    el("p.hint", {}, "A skin that lays layer on layer, sheets that grow at their rims, branches that fork. Nothing of the outline is drawn by hand."),
    fields.element,
    el("div.row-of", {}, el("span", {}, "seed"), reseed, seed, el("span.unit")),
    el("div.row-of", {}, el("span", {}, "growth"), growth, percent, iconButton("play", "Grow", grow, { "data-testid": "coral-grow" })),
    faults,
    handed.element,
    preset),
  el("section.drawing.sea", { "aria-label": "The coral" }, canvas,
    view ? null : el("p.fault", {}, "This browser has no WebGL 2, so nothing is drawn; a GLB file can be saved."),
    el("footer", {}, figures, savings)));

/** Whether a link is one of these. */
export const isCoralLink = (link: string): boolean => link.startsWith("coral=");

export const coralPage = {
  panel,
  /** Opens what a link carries, if it is not shown already; without one, what was shown last. */
  open: (link: string): void => {
    const said = new URLSearchParams(link), named = said.get("coral") ?? "", carried = unpacked(said.get("preset") ?? "");
    if (link !== "coral=" && link !== fragment()) {
      const known = species.has(named) ? named : FIRST;
      open(known, carried && new Preset(carried).organisms.length ? carried : species.get(known)!);
    } else if (!coral) open(name, text);
    else keep();
  },
  busy: (): boolean => busy() || share < 1,
};
