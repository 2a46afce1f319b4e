/** The grammar of an organism: rules that are typed, and what comes of them beside. */

import * as api from "../api";
import { codeArea, type CodeArea } from "../controls/code_area";
import { el, grouped, quiet } from "../dom";
import { grammarFileOf, isModel } from "../grammar_file";
import { getAt, isObject, toPointer, type Path } from "../pointer";
import type { Store } from "../store";
import { ofKind } from "./add_organism";
import { grammarFiles } from "./grammar_files";
import { docLink, nextStep } from "./help";

const LISTS = [
  ["rules", "Productions", "One a line: left < predecessor > right : condition ->(weight) successor"],
  ["interpretation", "Interpretation", "Rules that only the turtle sees"],
  ["decomposition", "Decomposition", "Rules that take symbols apart after each step"],
] as const;

/** A rule as a line: one with a limit says so before. */
const toLine = (rule: unknown): string => (isObject(rule) ? (rule.limit === undefined ? String(rule.rule ?? "") : `limit ${String(rule.limit)}: ${String(rule.rule ?? "")}`) : String(rule));

function fromLine(line: string): unknown {
  const limited = /^\s*limit\s+(\d+)\s*:\s*(.*)$/.exec(line);
  return limited ? { rule: limited[2], limit: Number(limited[1]) } : line;
}

export function grammarPanel(store: Store): { element: HTMLElement; opened(): void; closed(): void } {
  const pathTo = (...rest: Path): Path => {
    const entry = store.selected as number;
    const scope = store.preset.scope(entry, ["grammar", ...rest]);
    return scope === "all" ? ["defaults", "grammar", ...rest] : ["organisms", entry, "grammar", ...rest];
  };
  const grammar = (): unknown => (typeof store.selected === "number" ? store.preset.organism(store.selected).grammar : undefined);
  const file = (): string | null => (typeof store.selected === "number" ? grammarFileOf(store, store.selected) : null);
  const files = grammarFiles(store);
  let faults: api.Fault[] = [];
  let open = false;

  const axiom = el<HTMLInputElement>("input.text.code", { type: "text", "aria-label": "Axiom", spellcheck: false, "data-testid": "axiom" });
  axiom.addEventListener("input", () => store.set(pathTo("axiom"), axiom.value, "axiom"));
  axiom.addEventListener("change", () => store.endGesture());
  const axiomFault = el("p.fault");

  const areas = new Map<string, CodeArea>();
  const lists = LISTS.map(([name, label, about]) => {
    const area = codeArea(label, (text) => takeLines(name, text), { "data-testid": `rules:${name}` });
    area.box.addEventListener("blur", () => store.endGesture());
    areas.set(name, area);
    const said = el("p.fault", { role: "status" });
    const host = el("details.rules", {}, el("summary", { "data-tip": about }, label), area.element, said) as HTMLDetailsElement;
    host.open = name === "rules";
    return { name, area, said, host };
  });

  const pause = quiet(1200, () => store.endGesture());
  const takeLines = (name: string, text: string): void => {
    pause();
    // Empty lines at the end are the person's, no rules.
    const lines = text.replace(/\n+$/, "").split("\n").map(fromLine);
    const rules = text.trim() ? lines : [];
    if (rules.length) store.set(pathTo(name), rules, `rules ${name}`);
    else store.remove(pathTo(name));
  };

  // What comes of it

  const steps = el<HTMLInputElement>("input.slider", { type: "range", min: "0", step: "1", "aria-label": "Steps shown", "data-testid": "derive-steps" });
  const stepsShown = el("output");
  const figures = el("p.figures", { role: "status", "data-testid": "derive-figures" });
  const word = el("p.word.code", { tabIndex: 0, role: "region", "aria-label": "The word", "data-testid": "word" });
  const drawing = el<HTMLImageElement>("img", { alt: "What the turtle draws", hidden: true, "data-testid": "turtle-svg" });
  const tree = el<HTMLImageElement>("img", { alt: "The derivation tree", hidden: true, "data-testid": "derivation-tree" });
  const pictures = el("div.pictures", {}, el("figure", {}, drawing, el("figcaption", {}, "The turtle")), el("figure", {}, tree, el("figcaption", {}, "The derivation")));
  const symbols = el("dl.symbols");
  const rules = [el("label.axiom", {}, el("span", {}, "Axiom"), axiom), axiomFault, ...lists.map((l) => l.host)];
  const editor = el("div.grammar-editor", {},
    files.element, ...rules,
    el("details.rules", {}, el("summary", {}, "Symbols of the turtle"), symbols));
  const outcome = el("div.outcome", {}, el("div.steps", {}, el("span", {}, "Step"), steps, stepsShown), figures, word, pictures);
  const none = el("div");
  /** What a grammar is, and those that there are to look at. */
  const tellNone = (): void => {
    const grown = [...store.preset.organisms.keys()].filter((i) => getAt(store.preset.organism(i), ["grammar"]) !== undefined).slice(0, 3);
    none.replaceChildren(nextStep("A grammar is a few rules by which a plant grows: each step rewrites every letter of a word, and a turtle draws what comes of it. Plants have one, and corals of form “own”.",
      docLink("grammars.md", "Grammars"),
      ...grown.map((i): [string, () => void] => [`Show that of ${store.preset.nameOf(i)}`, () => store.select(i)]),
      ...(grown.length ? [] : [["Add a plant with a grammar", () => store.addOrganism(ofKind(store, "plant"))] as [string, () => void]])));
  };
  const element = el("div.grammar-panel", { "data-testid": "grammar-panel" }, none, editor, outcome);

  const derive = quiet(150, () => void show());
  let asked = 0;
  async function show(): Promise<void> {
    const mine = ++asked;
    const entry = store.selected;
    if (!open || typeof entry !== "number" || store.preset.syntax.length) return;
    const named = file();
    if (!named && !isObject(grammar())) return;
    try {
      if (named) {
        const read = await files.show(named, pathTo("file"), ownSteps());
        if (mine !== asked) return;
        if (isModel(named)) return showModel(read);
      }
      const answer = await api.derive(store.doc, entry, Number(steps.value) === Number(steps.max) ? null : Number(steps.value));
      if (mine !== asked) return;
      faults = Array.isArray(answer) ? answer : [];
      if (!Array.isArray(answer)) showOutcome(answer);
      outcome.classList.toggle("stale", Array.isArray(answer));
      markFaults();
    } catch (error) {
      figures.textContent = (error as Error).message;
    }
  }
  /** How many steps are shown; null: as many as the model makes by itself. */
  function ownSteps(): number | null {
    const own = getAt(grammar(), ["steps"]);
    if (steps.value !== steps.max) return Number(steps.value);
    return typeof own === "number" ? own : null;
  }
  function showModel(read: api.GrammarFiles): void {
    const own = getAt(grammar(), ["steps"]);
    const most = String(typeof own === "number" ? own : read.of);
    if (steps.max !== most) steps.max = steps.value = most;
    stepsShown.textContent = `${steps.value} of ${most}`;
    outcome.classList.toggle("stale", read.word === null);
    if (read.word === null) return;
    showOutcome({ word: read.word, length: read.length ?? 0, counts: read.counts, steps: read.steps, tree: null, svg: read.svg ?? null, predicted: null });
    if (read.notes.length) figures.textContent += ` ${read.notes.join(" ")}`;
  }
  function showOutcome(derived: api.Derived): void {
    const counts = Object.entries(derived.counts).sort((a, b) => b[1] - a[1]).slice(0, 8).map(([s, n]) => `${s} ${grouped(n)}`).join("  ");
    const whole = derived.predicted ? ` The whole: ${grouped(derived.predicted.modules)} symbols, ${grouped(derived.predicted.segments)} segments.` : "";
    figures.textContent = `${grouped(derived.length)} symbols after ${derived.steps} steps (${counts}).${whole}`;
    word.textContent = derived.word + (derived.length > derived.word.length ? " …" : "");
    showSvg(drawing, derived.svg);
    showSvg(tree, derived.tree);
  }
  function markFaults(): void {
    const all = [...faults, ...store.faults.filter((f) => !faults.some((g) => g.pointer === f.pointer))];
    for (const { name, area, said } of lists) {
      const within = [toPointer(pathTo(name)), toPointer(["defaults", "grammar", name])];
      const lines = new Map<number, string>();
      for (const fault of all) {
        const above = within.find((p) => fault.pointer.startsWith(p + "/"));
        if (above) lines.set(Number(fault.pointer.slice(above.length + 1).split("/")[0]) + 1, fault.text);
      }
      area.mark(lines);
      said.textContent = [...lines].map(([line, text]) => `${line}: ${text}`).join("\n");
    }
    const wrong = all.find((f) => f.pointer === toPointer(pathTo("axiom")) || f.pointer === toPointer(pathTo()));
    axiomFault.textContent = wrong?.text ?? "";
    axiom.setAttribute("aria-invalid", String(wrong !== undefined));
  }

  const refresh = (): void => {
    const value = grammar();
    const has = typeof store.selected === "number" && store.schema.kind(store.preset.kindOf(store.selected)).fields.has("grammar");
    none.hidden = has;
    if (!has && open) tellNone();
    editor.hidden = outcome.hidden = !has;
    if (!has || !open) return;
    const named = file();
    files.element.hidden = named === null;
    for (const part of rules) part.hidden = named !== null;
    if (named !== null && isModel(named)) return derive();
    if (document.activeElement !== axiom) axiom.value = String(getAt(value, ["axiom"]) ?? "");
    for (const { name, area, host } of lists) {
      const rules = getAt(value, [name]);
      const text = Array.isArray(rules) ? rules.map(toLine).join("\n") : "";
      if (area.box.value.replace(/\n+$/, "") !== text) area.show(text);
      area.box.rows = Math.max(name === "rules" ? 4 : 2, area.box.value.split("\n").length + 1);
      if (Array.isArray(rules) && rules.length) host.open = true;
    }
    const most = String(Math.min(Number(getAt(value, ["steps"]) ?? 1), 10000));
    if (steps.max !== most) steps.max = steps.value = most;
    stepsShown.textContent = `${steps.value} of ${most}`;
    derive();
  };
  steps.addEventListener("input", () => {
    stepsShown.textContent = `${steps.value} of ${steps.max}`;
    derive();
  });
  store.on(["text", "selected", "opened"], refresh);
  store.on("scene", () => open && typeof store.selected === "number" && markFaults());
  return {
    element,
    opened(): void {
      open = true;
      if (!symbols.childElementCount) symbols.replaceChildren(...store.symbols.map(({ symbol, doc }) => el("div", {}, el("dt.code", {}, symbol), el("dd", {}, doc))));
      refresh();
    },
    closed: () => void (open = false),
  };
}

/** As a picture, so that nothing in it can act. */
function showSvg(image: HTMLImageElement, svg: string | null): void {
  (image.parentElement as HTMLElement).hidden = image.hidden = !svg;
  if (svg) image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
}
