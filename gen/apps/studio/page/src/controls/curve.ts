/** Curves: points that are dragged, added and removed, by pointer or by keys. */

import { el, iconButton } from "../dom";
import type { NumberField, PlainField } from "../schema";
import { valueOf, type Control, type Place } from "./control";
import { numberBox, shown } from "./number";
import { rounded } from "./scale";

type Point = [number, number];
const WIDTH = 272;
const HEIGHT = 96;
const MARGIN = 9;
const ANY: NumberField = { type: "number", doc: "", unit: "", low: -1e6, high: 1e6, integer: false };

const pointsOf = (value: unknown): Point[] =>
  Array.isArray(value) ? value.filter((p): p is Point => Array.isArray(p) && p.length === 2) : [];

function svg(name: string, attributes: Record<string, string | number>): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}

export function curveControl(place: Place<PlainField>): Control {
  const { binding, label } = place;
  const plot = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "plot", role: "group", "aria-label": `${label}, points` });
  let points: Point[] = [];
  let chosen = 0;
  let held = -1;
  let span = { x: [0, 1] as Point, y: [0, 1] as Point };

  const toX = (x: number): number => MARGIN + ((x - span.x[0]) / (span.x[1] - span.x[0])) * (WIDTH - 2 * MARGIN);
  const toY = (y: number): number => HEIGHT - MARGIN - ((y - span.y[0]) / (span.y[1] - span.y[0])) * (HEIGHT - 2 * MARGIN);
  const fromPlot = (event: PointerEvent | MouseEvent): Point => {
    const box = plot.getBoundingClientRect();
    const px = ((event.clientX - box.left) / box.width) * WIDTH;
    const py = ((event.clientY - box.top) / box.height) * HEIGHT;
    const x = span.x[0] + ((px - MARGIN) / (WIDTH - 2 * MARGIN)) * (span.x[1] - span.x[0]);
    const y = span.y[0] + ((HEIGHT - MARGIN - py) / (HEIGHT - 2 * MARGIN)) * (span.y[1] - span.y[0]);
    return [rounded(x, 0.005), rounded(Math.max(0, y), 0.005)];
  };

  const put = (next: Point[], done: boolean): void => binding.set(next, done);
  const move = (index: number, to: Point, done: boolean): void => {
    const next = points.map((p, i) => (i === index ? to : p));
    // In a curve over x, points keep their order.
    if (isOverX()) next[index]![0] = Math.min(points[index + 1]?.[0] ?? 1, Math.max(points[index - 1]?.[0] ?? 0, to[0]));
    put(next, done);
  };
  const isOverX = (): boolean => points.every((p, i) => i === 0 || p[0] >= points[i - 1]![0]);
  const add = (at: Point): void => {
    const index = isOverX() ? points.findIndex((p) => p[0] > at[0]) : -1;
    chosen = index < 0 ? points.length : index;
    put(points.toSpliced(chosen, 0, at), true);
  };
  const addMiddle = (): void => {
    const [a, b] = [points[chosen] ?? [0, 1], points[chosen + 1] ?? points[chosen - 1] ?? [1, 1]];
    add([rounded((a[0] + b[0]) / 2, 0.005), rounded((a[1] + b[1]) / 2, 0.005)]);
  };
  const remove = (index: number): void => {
    if (points.length <= 2) return;
    chosen = Math.max(0, index - 1);
    put(points.toSpliced(index, 1), true);
  };

  const keys = (event: KeyboardEvent, index: number): void => {
    const step = event.shiftKey ? 0.1 : 0.01;
    const [x, y] = points[index]!;
    const moves: Record<string, Point> = { ArrowLeft: [x - step, y], ArrowRight: [x + step, y], ArrowUp: [x, y + step], ArrowDown: [x, Math.max(0, y - step)] };
    const to = moves[event.key];
    if (to) move(index, [rounded(to[0], 0.005), rounded(to[1], 0.005)], true);
    else if (event.key === "Delete" || event.key === "Backspace") remove(index);
    else return;
    event.preventDefault();
    (plot.querySelectorAll<SVGElement>(".point")[chosen] ?? null)?.focus();
  };

  plot.addEventListener("dblclick", (event) => add(fromPlot(event)));
  plot.addEventListener("pointermove", (event) => held >= 0 && move(held, fromPlot(event), false));
  plot.addEventListener("pointerup", () => {
    held = -1;
    binding.store.endGesture();
  });

  let drawn = "";
  const draw = (): void => {
    const state = JSON.stringify([points, held]);
    if (state === drawn) return;
    drawn = state;
    const xs = points.map((p) => p[0]);
    const ys = points.map((p) => p[1]);
    if (held < 0) span = { x: [Math.min(0, ...xs), Math.max(isOverX() ? 1 : 0.01, ...xs)], y: [Math.min(0, ...ys), Math.max(1, ...ys)] };
    const line = points.map((p) => `${toX(p[0])},${toY(p[1])}`).join(" ");
    const grid = [0.25, 0.5, 0.75].map((s) => `M${MARGIN + s * (WIDTH - 2 * MARGIN)} ${MARGIN}V${HEIGHT - MARGIN}`).join("");
    plot.replaceChildren(svg("path", { d: `M${MARGIN} ${HEIGHT - MARGIN}H${WIDTH - MARGIN}${grid}`, class: "grid" }), svg("polyline", { points: line, class: "line" }));
    points.forEach((p, i) => plot.append(handle(p, i)));
  };
  const handle = (p: Point, i: number): SVGElement => {
    const dot = svg("circle", { cx: toX(p[0]), cy: toY(p[1]), r: 5, class: i === chosen ? "point chosen" : "point", tabindex: 0, role: "slider" });
    dot.setAttribute("aria-label", `${label}, point ${i + 1}`);
    dot.setAttribute("aria-valuenow", shown(p[1]));
    dot.setAttribute("aria-valuetext", `${shown(p[0])}, ${shown(p[1])}`);
    dot.addEventListener("pointerdown", (event) => {
      held = chosen = i;
      plot.setPointerCapture((event as PointerEvent).pointerId);
      showChosen();
      event.preventDefault();
    });
    dot.addEventListener("focus", () => {
      chosen = i;
      showChosen();
    });
    dot.addEventListener("keydown", (event) => keys(event as KeyboardEvent, i));
    return dot;
  };

  const boxes = [0, 1].map((axis) =>
    numberBox(`${label}, chosen point, ${axis ? "second" : "first"} number`, ANY, (value, done) => {
      const to: Point = [...(points[chosen] ?? [0, 0])];
      to[axis] = value;
      move(chosen, to, done);
    }),
  );
  const showChosen = (): void => {
    chosen = Math.min(chosen, Math.max(0, points.length - 1));
    boxes.forEach((box, axis) => box.show(points[chosen]?.[axis] ?? ""));
    plot.querySelectorAll(".point").forEach((dot, i) => dot.classList.toggle("chosen", i === chosen));
  };
  const tools = el("span.vector", {}, ...boxes.map((box) => el("span.boxed", {}, box)),
    iconButton("add", `Add a point to ${label}`, addMiddle), iconButton("remove", `Remove the chosen point of ${label}`, () => remove(chosen)));
  const element = el("div.curve", {}, plot, tools);
  return {
    element,
    wide: true,
    refresh(): void {
      points = pointsOf(valueOf(place));
      const focused = [...plot.querySelectorAll(".point")].indexOf(document.activeElement as Element);
      draw();
      showChosen();
      if (focused >= 0) plot.querySelectorAll<SVGElement>(".point")[chosen]?.focus();
    },
  };
}
