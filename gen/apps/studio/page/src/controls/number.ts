/** Numbers: a slider with a box, or a box alone. */

import { el, iconButton, quiet } from "../dom";
import type { NumberField } from "../schema";
import { isTyping, valueOf, type Control, type Place } from "./control";
import { reckon } from "./reckon";
import { isBoundless, rounded, usualScale, valueAt } from "./scale";

/** Five digits are enough to see; whole numbers have all of theirs. */
export const shown = (value: unknown): string =>
  typeof value === "number" ? String(Number.isInteger(value) ? value : Number(value.toPrecision(5))) : String(value ?? "");

/**
 * A box for a number, in which one may reckon: "2*0.7", "50cm". Up and down change it by a step, with Shift by ten. What is
 * no number stays, marked and with what is wrong with it, which "misread" tells the row as well. A drag to the side in a box
 * that nobody types in changes it, too. `put` gets each change, and whether the person is done with it.
 */
export function numberBox(label: string, field: NumberField, put: (value: number, done: boolean) => void): HTMLInputElement & { show(value: unknown): void } {
  const box = el<HTMLInputElement>("input.number", { type: "text", inputMode: "text", "aria-label": label, autocomplete: "off", spellcheck: false });
  let last: unknown = "";
  const mark = (wrong: string): void => {
    if ((box.dataset.wrong ?? "") === wrong) return;
    if (wrong) box.dataset.wrong = wrong;
    else delete box.dataset.wrong;
    box.setAttribute("aria-invalid", String(wrong !== ""));
    box.title = wrong;
    box.dispatchEvent(new CustomEvent("misread", { bubbles: true, detail: wrong }));
  };
  const take = (): void => {
    delete box.dataset.touched;
    const found = reckon(box.value, field.unit);
    if ("wrong" in found) return mark(box.value.trim() ? found.wrong : "");
    mark("");
    last = field.integer ? Math.round(found.value) : found.value;
    put(last as number, true);
    box.value = shown(last);
  };
  box.addEventListener("input", () => (box.dataset.touched = "yes"));
  box.addEventListener("change", () => {
    take();
    // Nothing is typed: what counts is shown.
    if (!box.value.trim()) box.value = shown(last);
  });
  box.addEventListener("focus", () => box.select());
  box.addEventListener("keydown", (event) => {
    if (event.key === "Enter") take();
    if (event.key === "Escape" && box.dataset.wrong) {
      event.stopPropagation();
      delete box.dataset.touched;
      mark("");
      box.value = shown(last);
    }
    if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
    event.preventDefault();
    stepFrom(now(), (event.shiftKey ? 10 : 1) * (event.key === "ArrowUp" ? 1 : -1));
  });
  const now = (): number => {
    const found = reckon(box.value, field.unit);
    return "value" in found ? found.value : Number(last) || 0;
  };
  const stepFrom = (from: number, steps: number): void => {
    const size = field.integer ? 1 : Math.max(10 ** (Math.floor(Math.log10(Math.abs(from) || 1)) - 1), 1e-5);
    const next = Math.min(field.high, Math.max(field.low, rounded(from + steps * size, field.integer ? 1 : size / 10)));
    mark("");
    last = next;
    put(next, false);
    box.value = shown(next);
  };
  dragIn(box, now, stepFrom, () => put(Number(last), true));
  const show = (value: unknown): void => {
    if (isTyping(box) || box.dataset.wrong) return;
    last = value;
    if (box.value !== shown(value)) box.value = shown(value);
  };
  return Object.assign(box, { show });
}

const STEP = 6; // pixels of a drag

/** A drag to the side in a box that has not the focus: `step` gets the value that it began with, and how many steps from there. */
function dragIn(box: HTMLInputElement, now: () => number, step: (from: number, steps: number) => void, done: () => void): void {
  let begun: { x: number; from: number; steps: number } | null = null;
  box.addEventListener("pointerdown", (event) => {
    if (event.button === 0 && document.activeElement !== box) begun = { x: event.clientX, from: now(), steps: 0 };
  });
  box.addEventListener("pointermove", (event) => {
    if (!begun) return;
    const steps = Math.trunc((event.clientX - begun.x) / STEP);
    if (steps === begun.steps) return;
    begun.steps = steps;
    box.setPointerCapture(event.pointerId);
    step(begun.from, steps * (event.shiftKey ? 10 : 1));
  });
  const end = (): void => {
    // A mere click is for typing.
    if (begun && begun.steps !== 0) {
      done();
      box.blur();
    }
    begun = null;
  };
  box.addEventListener("pointerup", end);
  box.addEventListener("pointercancel", end);
}

export function numberControl(place: Place<NumberField>): Control {
  const { field, binding, label } = place;
  const box = numberBox(label, field, (value, done) => binding.set(value, done));
  const boxed = el("span.boxed", {}, box, field.unit && el("span.unit", {}, field.unit));
  if (isBoundless(field)) return bareNumber(place, box, boxed);

  const valueNow = (): number => Number(valueOf(place) ?? field.low);
  let scale = usualScale(field, valueNow());
  const slider = el<HTMLInputElement>("input.slider", { type: "range", min: "0", max: String(scale.steps), step: "1", "aria-label": `${label}, slider` });
  const fill = (): void => slider.style.setProperty("--fill", `${(100 * Number(slider.value)) / scale.steps}%`);
  const move = (done: boolean): void => {
    const value = valueAt(scale, field, Number(slider.value) / scale.steps);
    slider.dataset.held = "yes";
    binding.set(value, done);
    delete slider.dataset.held;
    box.show(value);
    fill();
  };
  slider.addEventListener("input", () => move(false));
  // Steps by keys that follow each other are one to undo.
  const rest = quiet(600, () => binding.store.endGesture());
  slider.addEventListener("change", rest);
  return {
    element: el("span.slide", {}, slider, boxed),
    refresh(): void {
      const value = valueNow();
      box.show(valueOf(place) ?? "");
      const said = `${shown(value)} ${field.unit}`;
      if (slider.getAttribute("aria-valuetext") === said) return;
      slider.setAttribute("aria-valuetext", said);
      if (slider.dataset.held) return;
      // What was typed may lie beyond what the slider reaches.
      if (value > scale.high || value < scale.low) scale = usualScale(field, value);
      slider.max = String(scale.steps);
      slider.value = String(Math.round(scale.toWay(value) * scale.steps));
      fill();
    },
  };
}

/** Seeds get a die. */
function bareNumber(place: Place<NumberField>, box: ReturnType<typeof numberBox>, boxed: HTMLElement): Control {
  const roll = iconButton("dice", `Another ${place.label}`, () => place.binding.set(anySeed()));
  const isSeed = place.label === "seed";
  if (isSeed) roll.dataset.testid = "seed-dice";
  return { element: el("span.slide.bare", {}, boxed, isSeed && roll), refresh: () => box.show(valueOf(place)) };
}

export const anySeed = (): number => Math.floor(Math.random() * 100000);
