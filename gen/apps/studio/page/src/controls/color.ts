/** Colours: the system's picker, and the same as text. */

import { el } from "../dom";
import type { PlainField } from "../schema";
import { getAt } from "../pointer";
import { isTyping, valueOf, type Control, type Place } from "./control";

const byte = (share: number): string => Math.round(255 * Math.min(1, Math.max(0, share))).toString(16).padStart(2, "0");

/** The same colour as "#rrggbb", of [0.85, 0.54, 0.31], CSS or a place in the palettes; undefined where it is none. */
export function hexOf(value: unknown, palettes: unknown): string | undefined {
  if (Array.isArray(value) && value.length === 3) return "#" + value.map((v) => byte(Number(v))).join("");
  if (typeof value !== "string") return undefined;
  const place = /^palette:(.*?)(?:\/(\d+))?$/.exec(value);
  if (place) return hexOf(getAt(palettes, [place[1]!, Number(place[2] ?? 0)]), undefined);
  if (!CSS.supports("color", value)) return undefined;
  const pen = document.createElement("canvas").getContext("2d")!;
  pen.fillStyle = value;
  const opaque = /^#[0-9a-f]{6}$/.exec(pen.fillStyle);
  return opaque?.[0];
}

export function colorControl(place: Place<PlainField>): Control {
  const { binding, label } = place;
  const hex = (value: unknown): string | undefined => hexOf(value, binding.store.preset.whole.palettes);
  const swatch = el<HTMLInputElement>("input.swatch", { type: "color", "aria-label": `${label}, colour` });
  swatch.addEventListener("input", () => binding.set(swatch.value, false));
  swatch.addEventListener("change", () => binding.store.endGesture());
  const box = el<HTMLInputElement>("input.text.code", { type: "text", "aria-label": `${label}, as CSS writes it`, spellcheck: false, autocomplete: "off" });
  box.addEventListener("input", () => {
    box.dataset.touched = "yes";
    const fits = hex(box.value) !== undefined;
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
    const shown = hex(value) ?? "#000000";
    swatch.value = shown;
    if (isTyping(box)) return;
    box.value = value === undefined ? "" : typeof value === "string" ? value : shown;
    box.removeAttribute("aria-invalid");
  };
  return { element: el("span.color", {}, swatch, box), refresh };
}
