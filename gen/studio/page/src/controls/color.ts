/** Colours: the system's picker, and the same as text. */

import { el } from "../dom";
import type { PlainField } from "../schema";
import { isTyping, valueOf, type Control, type Place } from "./control";

const byte = (share: number): string => Math.round(255 * Math.min(1, Math.max(0, share))).toString(16).padStart(2, "0");

/** "#d98a4e", also of [0.85, 0.54, 0.31]. */
function hexOf(value: unknown): string {
  if (Array.isArray(value) && value.length === 3) return "#" + value.map((v) => byte(Number(v))).join("");
  return typeof value === "string" && /^#[0-9a-f]{6}$/i.test(value) ? value.toLowerCase() : "#000000";
}

export function colorControl(place: Place<PlainField>): Control {
  const { binding, label } = place;
  const swatch = el<HTMLInputElement>("input.swatch", { type: "color", "aria-label": `${label}, colour` });
  swatch.addEventListener("input", () => binding.set(swatch.value, false));
  swatch.addEventListener("change", () => binding.store.endGesture());
  const box = el<HTMLInputElement>("input.text.code", { type: "text", "aria-label": `${label}, as #rrggbb`, maxLength: 7, spellcheck: false, autocomplete: "off" });
  box.addEventListener("input", () => {
    box.dataset.touched = "yes";
    const fits = /^#[0-9a-f]{6}$/i.test(box.value);
    box.toggleAttribute("aria-invalid", !fits);
    if (fits) binding.set(box.value, false);
  });
  box.addEventListener("change", () => {
    delete box.dataset.touched;
    binding.store.endGesture();
    refresh();
  });
  const refresh = (): void => {
    const value = valueOf(place);
    const hex = hexOf(value);
    swatch.value = hex;
    if (isTyping(box)) return;
    box.value = value === undefined ? "" : hex;
    box.removeAttribute("aria-invalid");
  };
  return { element: el("span.color", {}, swatch, box), refresh };
}
