/** Values over the film's time as curves, whose keys are dragged: along in time, up and down in value. */

import { el } from "../dom";
import { EASES, shapeOf, valueAtTime, withKey, type Ease, type Key } from "../keyframes";
import { toPointer } from "../pointer";
import { spelled, type NumberField } from "../schema";
import { rounded } from "../controls/scale";
import { shown } from "../controls/number";
import type { Store } from "../store";
import { docLink, nextStep } from "./help";
import { listsOf, removeKeys, setEase, timeFor, withPart, type KeyList, type KeyPlace } from "./key_edits";

const MARGIN = { left: 46, right: 14, top: 12, bottom: 20 };
const PIECES = 200;
const GESTURE = "keys on a curve";
const STILL = 3; // pixels that a press moves before it is a drag
const AXES = ["x", "y", "z"];

const numbersOf = (value: unknown): number[] => (Array.isArray(value) ? value : [value]).map(Number);
/** A number of a value: of a vector the one of an axis. */
const partOf = (keys: Key[], axis: number): (string | number)[] => (Array.isArray(keys[0]![1]) ? [1, axis] : [1]);

function svg(name: string, attributes: Record<string, string | number>, text = ""): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  made.textContent = text;
  return made;
}

export function curvesPanel(store: Store): { element: HTMLElement; opened(): void; closed(): void } {
  const which = el<HTMLSelectElement>("select", { "aria-label": "Value", "data-testid": "curve-of", change: () => choose(which.value) });
  const none = el("div", { hidden: true });
  const told = el("p.hint", { role: "status", "data-testid": "curve-told" });
  const eases = ([null, ...EASES] as (Ease | null)[]).map((ease) =>
    el<HTMLButtonElement>("button", { type: "button", "data-testid": `curve-ease:${ease ?? "smooth"}`, "data-tip": ease ? TIPS[ease] : "As fast as at the keys beside it", click: () => ease !== undefined && put(ease) }, ease ?? "smooth"));
  const way = el("span.segments", { role: "group", "aria-label": "The way to the next key" }, ...eases);
  const add = el("button.small", { type: "button", "data-testid": "curve-add", click: () => insert(store.time) }, "Key at the time shown");
  const plot = svg("svg", { class: "plot", role: "group", "aria-label": "Keys over time", "data-testid": "curve-plot" });
  const element = el("div.curves", {}, none, el("div.curve-side", {}, which, told, el("label", {}, "To the next key"), way, add), plot as unknown as HTMLElement);
  let open = false;
  let of = "";
  let chosen = 0;
  let held: { low: number; high: number } | null = null;

  const lists = (): KeyList[] => listsOf(store).filter(({ keys }) => keys.every(([, value]) => numbersOf(value).every(Number.isFinite)));
  const list = (): KeyList | undefined => lists().find(({ path }) => toPointer(path) === of);
  const placeOf = ({ path, keys }: KeyList, index: number): KeyPlace => ({ list: path, keys, index });
  const choose = (pointer: string): void => {
    of = pointer;
    chosen = 0;
    draw();
  };

  // How time and value lie in the plot

  const size = (): [number, number] => [plot.clientWidth || 600, plot.clientHeight || 160];
  const span = (keys: Key[]): { low: number; high: number } => {
    if (held) return held;
    const all = keys.flatMap(([, value]) => numbersOf(value));
    const [low, high] = [Math.min(...all), Math.max(...all)];
    const air = (high - low || Math.abs(high) || 1) * 0.15;
    return { low: low - air, high: high + air };
  };
  const end = (): number => Math.max(store.preset.end, 1e-3);
  const toX = (time: number): number => MARGIN.left + (time / end()) * (size()[0] - MARGIN.left - MARGIN.right);
  const fromX = (x: number): number => ((x - MARGIN.left) / (size()[0] - MARGIN.left - MARGIN.right)) * end();
  const toY = (value: number, keys: Key[]): number => {
    const { low, high } = span(keys);
    return size()[1] - MARGIN.bottom - ((value - low) / (high - low)) * (size()[1] - MARGIN.top - MARGIN.bottom);
  };
  const perPixel = (keys: Key[]): number => (span(keys).high - span(keys).low) / (size()[1] - MARGIN.top - MARGIN.bottom);

  /** Within what the preset allows, and to so many digits that a pixel shows. */
  function valueFor({ path, keys }: KeyList, axis: number, value: number): number {
    const field = store.schema.at(path, store.kinds);
    const base = field?.type === "keyed" ? field.base : undefined;
    const range: Partial<NumberField> | undefined = base?.type === "number" ? base : base?.type === "vector" ? base.items[axis] : undefined;
    return rounded(Math.min(range?.high ?? Infinity, Math.max(range?.low ?? -Infinity, value)), perPixel(keys));
  }

  // Acts

  function move(at: KeyList, index: number, axis: number, time: number, value: number): void {
    const place = placeOf(at, index);
    const timed = withPart(store, store.text, place, [0], timeFor(store, [place], time));
    store.change(withPart(store, timed, place, partOf(at.keys, axis), valueFor(at, axis, value)), GESTURE);
  }
  function put(ease: Ease | null): void {
    const at = list();
    if (at) setEase(store, placeOf(at, chosen), ease);
  }
  function insert(near: number): void {
    const at = list();
    if (!at) return;
    const time = Math.round(near * store.preset.fps) / store.preset.fps;
    const keys = withKey(at.keys, time, valueAtTime(at.keys, time));
    chosen = keys.findIndex(([t]) => Math.abs(t - time) < 1 / store.preset.fps);
    store.set(at.path, keys);
  }

  function drag(event: PointerEvent, index: number, axis: number): void {
    const at = list();
    if (event.button !== 0 || !at) return;
    const [time, value] = [at.keys[index]![0], numbersOf(at.keys[index]![1])[axis]!];
    const unit = perPixel(at.keys);
    chosen = index;
    held = span(at.keys);
    let dragged = false;
    const going = (e: PointerEvent): void => {
      const [x, y] = [e.clientX - event.clientX, e.clientY - event.clientY];
      dragged ||= Math.hypot(x, y) > STILL;
      if (dragged) move(at, index, axis, time + fromX(MARGIN.left + x), value - y * unit);
    };
    plot.setPointerCapture(event.pointerId);
    plot.addEventListener("pointermove", going);
    plot.addEventListener("lostpointercapture", () => {
      plot.removeEventListener("pointermove", going);
      held = null;
      store.endGesture();
      if (!dragged) store.setTime(time);
      draw();
      focus(index, axis);
    }, { once: true });
    event.preventDefault();
    event.stopPropagation();
  }

  function key(event: KeyboardEvent, index: number, axis: number): void {
    const at = list();
    if (!at) return;
    const far = event.shiftKey ? 10 : 1;
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (step) {
      const { low, high } = span(at.keys);
      const [time, value] = [at.keys[index]![0], numbersOf(at.keys[index]![1])[axis]!];
      move(at, index, axis, time + (far * step[0]!) / store.preset.fps, value + (far * step[1]! * (high - low)) / 100);
      store.endGesture();
      focus(index, axis);
    } else if (event.key === "Delete") {
      chosen = Math.max(0, index - 1);
      removeKeys(store, [placeOf(at, index)]);
      focus(chosen, axis);
    } else if (event.key === "Enter") store.setTime(at.keys[index]![0]);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
  const focus = (index: number, axis: number): void => plot.querySelector<SVGElement>(`[data-testid="curve-key:${index}:${axis}"]`)?.focus();

  plot.addEventListener("pointerdown", (event) => store.setTime(Math.max(0, Math.min(store.preset.end, fromX(event.clientX - plot.getBoundingClientRect().left)))));
  plot.addEventListener("dblclick", (event) => insert(fromX(event.clientX - plot.getBoundingClientRect().left)));

  // What is drawn

  function grid(keys: Key[]): SVGElement[] {
    const [wide, high] = size();
    const { low, high: top } = span(keys);
    return [0, 0.25, 0.5, 0.75, 1].flatMap((share) => {
      const [time, value] = [share * end(), low + share * (top - low)];
      return [
        svg("path", { d: `M${toX(time)} ${MARGIN.top}V${high - MARGIN.bottom}M${MARGIN.left} ${toY(value, keys)}H${wide - MARGIN.right}`, class: "grid" }),
        svg("text", { x: toX(time), y: high - 6, class: "time" }, `${shown(rounded(time, 0.01))} s`),
        svg("text", { x: MARGIN.left - 5, y: toY(value, keys) + 4, class: "value" }, shown(rounded(value, (top - low) / 100))),
      ];
    });
  }
  function lineOf(keys: Key[], axis: number): SVGElement {
    const points = Array.from({ length: PIECES + 1 }, (_, i) => (i / PIECES) * end());
    return svg("polyline", { class: `line axis${axis}`, points: points.map((t) => `${toX(t)},${toY(numbersOf(valueAtTime(keys, t))[axis]!, keys)}`).join(" ") });
  }
  function dot(at: KeyList, index: number, axis: number): SVGElement {
    const [time, value] = [at.keys[index]![0], numbersOf(at.keys[index]![1])[axis]!];
    const made = svg("circle", { cx: toX(time), cy: toY(value, at.keys), r: 5, class: `point axis${axis}${index === chosen ? " chosen" : ""}`, tabindex: 0, role: "slider", "data-testid": `curve-key:${index}:${axis}`, "aria-label": `Key ${index + 1}${numbersOf(at.keys[0]![1]).length > 1 ? `, ${AXES[axis]}` : ""}`, "aria-valuenow": value, "aria-valuetext": `${shown(value)} at ${shown(time)} s` });
    made.addEventListener("pointerdown", (event) => drag(event as PointerEvent, index, axis));
    made.addEventListener("keydown", (event) => key(event as KeyboardEvent, index, axis));
    made.addEventListener("dblclick", (event) => event.stopPropagation());
    made.addEventListener("focus", () => {
      chosen = index;
      tell(at);
    });
    return made;
  }
  function tell(at: KeyList | undefined): void {
    const found = at?.keys[chosen];
    const last = !at || chosen >= at.keys.length - 1;
    told.textContent = !at ? "Nothing that is selected has keys: the diamond beside a value gives it some." : found ? `Key ${chosen + 1} of ${at.keys.length}: ${numbersOf(found[1]).map(shown).join(", ")} at ${shown(found[0])} s` : "";
    const now = found ? (shapeOf(found).ease ?? null) : null;
    eases.forEach((button, i) => {
      button.disabled = last;
      button.setAttribute("aria-pressed", String(!last && now === [null, ...EASES][i]));
    });
    plot.querySelectorAll(".point").forEach((one) => one.classList.toggle("chosen", one.getAttribute("data-testid")!.startsWith(`curve-key:${chosen}:`)));
  }
  function draw(): void {
    if (!open) return;
    const all = lists();
    if (!all.some(({ path }) => toPointer(path) === of)) of = all[0] ? toPointer(all[0].path) : "";
    which.replaceChildren(...all.map(({ path }) => el("option", { value: toPointer(path), selected: toPointer(path) === of }, labelOf(store, path))));
    which.hidden = add.hidden = way.hidden = !all.length;
    const still = store.preset.end === 0;
    none.hidden = all.length > 0;
    element.classList.toggle("none", !all.length);
    if (!all.length)
      none.replaceChildren(nextStep(
        still ? "Curves draw how values change over a film. This preset is a still: give it some frames first." : "Curves draw how values change over the film. The diamond beside a value gives it keys; the camera is a good one to begin with.",
        docLink("tutorial.md", "An hour by hand"),
        still ? ["Make it a film of 3 seconds", () => store.set(["film", "frames"], 1 + Math.round(3 * store.preset.fps))] : ["Show what can move in the scene", () => store.select("scene")],
      ));
    const at = list();
    const focused = (document.activeElement as HTMLElement | null)?.dataset.testid ?? "";
    plot.replaceChildren();
    if (at) {
      chosen = Math.min(chosen, at.keys.length - 1);
      const axes = numbersOf(at.keys[0]![1]).map((_, axis) => axis);
      plot.append(...grid(at.keys), svg("path", { d: `M${toX(store.time)} ${MARGIN.top}V${size()[1] - MARGIN.bottom}`, class: "now" }),
        ...axes.map((axis) => lineOf(at.keys, axis)), ...at.keys.flatMap((_, index) => axes.map((axis) => dot(at, index, axis))));
    }
    if (focused.startsWith("curve-key:")) plot.querySelector<SVGElement>(`[data-testid="${focused}"]`)?.focus();
    tell(at);
  }
  store.on(["text", "selected", "time", "opened"], draw);
  new ResizeObserver(draw).observe(plot);
  return {
    element,
    opened(): void {
      open = true;
      draw();
    },
    closed: () => void (open = false),
  };
}

const TIPS: Record<Ease, string> = { none: "At an even pace", in: "Slow at the beginning", out: "Slow at the end", both: "Slow at the beginning and at the end" };

/** "camera / angle", or with the name of an organism. */
function labelOf(store: Store, path: (string | number)[]): string {
  const [first, entry, ...rest] = path;
  const names = first === "organisms" ? [store.preset.nameOf(Number(entry)), ...rest] : path.slice(1);
  return names.map((name) => spelled(String(name))).join(" / ");
}
