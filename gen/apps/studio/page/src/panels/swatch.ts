/** What the selected organism is made of, drawn by POV-Ray: on a ball, and on itself as one sees it now. */

import * as api from "../api";
import { el, quiet, sleep } from "../dom";
import { setAt } from "../edits";
import { materialOf } from "../materials";
import type { Store } from "../store";
import type { View } from "../view/view";
import { say } from "./dialogs";
import { swap } from "./swap";

const SIZE: [number, number] = [240, 180];
/** So long nothing is changed before a ball is drawn, ms. */
const CALM = 500;

export function swatch(store: Store, view: View): HTMLElement {
  const ball = el<HTMLImageElement>("img", { alt: "Its material on a ball", "data-testid": "swatch", hidden: true });
  const plant = el<HTMLImageElement>("img", { alt: "Its material as one sees it now", "data-testid": "swatch-plant", hidden: true });
  const button = el<HTMLButtonElement>("button.small", { type: "button", "data-tip": "POV-Ray draws a small picture from where you look now", "data-testid": "on-plant", click: () => void onPlant() }, "As it looks there");
  const swapOf = (what: "leaves" | "surface", label: string, tip: string): HTMLButtonElement =>
    el<HTMLButtonElement>("button.small", { type: "button", "data-tip": tip, "data-testid": `swap-${what}`, click: () => void swap(store, entry()!, what) }, label);
  const surface = swapOf("surface", "Swap it …", "Another bark, skin or stone, by its picture");
  const leaves = swapOf("leaves", "Swap leaves …", "The leaves of another preset, by its picture");
  const element = el("div.made-of", { role: "group", "aria-label": "Material", hidden: true }, ball, plant, button, surface, leaves);
  let shown = "";
  let asked: AbortController | null = null;

  const entry = (): number | null => (store.isOpen && typeof store.selected === "number" && store.preset.organisms[store.selected] ? store.selected : null);
  const show = (picture: HTMLImageElement, from: string | null): void => {
    picture.hidden = from === null;
    if (from !== null) picture.src = from;
  };

  const draw = quiet(CALM, () => {
    const which = entry();
    if (which === null || store.faults.length) return;
    if (store.scene.busy) return draw(); // what grows goes first
    asked?.abort();
    const { signal } = (asked = new AbortController());
    void api.ball(store.doc, which, signal).catch(() => null).then((picture) => {
      if (signal.aborted) return;
      const address = picture && URL.createObjectURL(picture);
      if (address) ball.addEventListener("load", () => URL.revokeObjectURL(address), { once: true });
      show(ball, address);
    });
  });
  const refresh = (): void => {
    const which = entry();
    element.hidden = which === null;
    leaves.hidden = which === null || !store.schema.kind(store.preset.kindOf(which)).fields.has("leaves");
    const now = which === null ? "" : JSON.stringify([store.file, which, store.preset.kindOf(which), materialOf(store.preset.organism(which))]);
    if (now === shown) return;
    shown = now;
    show(plant, null);
    draw();
  };

  async function onPlant(): Promise<void> {
    const { at, to } = view.eye();
    const camera = { location: at, look_at: to, angle: view.angleAcross(SIZE[0] / SIZE[1]) };
    button.disabled = true;
    try {
      const answer = await api.render({ ...store.doc, text: setAt(store.text, ["scene", "camera"], camera) }, store.time, SIZE, "draft");
      if (Array.isArray(answer)) return say(answer[0]?.text ?? "This preset cannot be rendered", true);
      for (;;) {
        const { state, message } = await api.renderState(answer.id);
        if (state === "done") return show(plant, api.renderPicture(answer.id));
        if (state !== "growing" && state !== "rendering") return say(message || "POV-Ray drew nothing", true);
        await sleep(150);
      }
    } catch (error) {
      say((error as Error).message, true);
    } finally {
      button.disabled = false;
    }
  }
  store.on(["text", "selected", "opened"], refresh);
  return element;
}
