/** Another bark of the branch that is picked: some that are usual, and its colour. */

import { hexOf } from "../controls/color";
import { el } from "../dom";

export type Bark = Record<string, unknown>;

const USUAL: Record<string, { label: string; bark: Bark }> = {
  dead: { label: "Dead, grey", bark: { color: "#8d8880", second: "#4b4742" } },
  lichens: { label: "Under lichens", bark: { lichens: 0.8 } },
  furrowed: { label: "Furrowed", bark: { pattern: "furrowed", color: "#736150", second: "#2b211a" } },
  plated: { label: "Plates, as a pine's", bark: { pattern: "plated", color: "#8a5a3c", second: "#3a241a" } },
  smooth: { label: "Smooth, as a beech's", bark: { pattern: "smooth", color: "#8b8d86", second: "#5d5f59" } },
  birch: { label: "A birch's", bark: { kind: "birch", pattern: "banded", color: "#e4e0d6", second: "#2e2a27" } },
  painted: { label: "Painted", bark: { kind: "ink", color: "#b3362b" } },
  metal: { label: "Metal", bark: { kind: "metal", color: "#b48a4a" } },
};
const OWN = "own";
const OTHER = "other";

export class OtherBark {
  readonly element: HTMLElement;
  private list: HTMLSelectElement;
  private color: HTMLInputElement;
  private bark: Bark | undefined;

  /** `give` is told the bark, or nothing where the branch is to have the plant's own; `done` ends a gesture. */
  constructor(give: (bark: Bark | undefined) => void, done: () => void) {
    const option = (value: string, label: string): HTMLElement => el("option", { value }, label);
    this.list = el<HTMLSelectElement>(
      "select", { "aria-label": "Bark of the branch", "data-tip": "Another bark on it, and on what hangs on it", "data-testid": "branch:bark" },
      option(OWN, "The plant's bark"),
      ...Object.entries(USUAL).map(([name, { label }]) => option(name, label)),
      option(OTHER, "Another bark"),
    );
    this.list.addEventListener("change", () => {
      const { value } = this.list;
      if (value !== OTHER) give(USUAL[value] && { ...USUAL[value].bark });
      else if (!this.bark) give({ color: this.color.value });
      done();
    });
    this.color = el<HTMLInputElement>("input.swatch", { type: "color", "aria-label": "Colour of the branch's bark", "data-testid": "branch:bark-color" });
    this.color.addEventListener("input", () => give({ ...this.bark, color: this.color.value }));
    this.color.addEventListener("change", done);
    this.element = el("span.cluster", {}, this.list, this.color);
  }

  /** Shows what the branch wears; nothing: the plant's own. */
  show(bark: Bark | undefined, palettes: unknown): void {
    this.bark = bark;
    const same = (other: Bark): boolean => JSON.stringify({ ...other, color: 0 }) === JSON.stringify({ ...bark, color: 0 });
    const usual = Object.entries(USUAL).filter(([, one]) => same(one.bark));
    const exact = usual.find(([, one]) => one.bark.color === bark?.color) ?? usual[0];
    this.list.value = !bark ? OWN : (exact?.[0] ?? OTHER);
    this.color.value = hexOf(bark?.color, palettes) ?? "#8d8880";
  }
}
