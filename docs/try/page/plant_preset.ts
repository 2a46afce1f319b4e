/** A preset of one plant that grows by a grammar, in soft light before a wall, as `frond import` writes them. */

import { spaced, textOf, type Form } from "./form";
import { COLORS, type Shapes } from "./shapes";

const ANGLE = 32; // degrees, what the camera sees across

const hex = (color: number): string => `#${color.toString(16).padStart(6, "0")}`;
const digits = (x: number): number => Number(x.toPrecision(4));

/** The text of the preset; `shapes` is what was drawn last, whose longest side becomes a metre. */
export function plantPreset(form: Form, title: string, shapes: Shapes | null): string {
  const [wide, high, deep] = shapes ? shapes.half.map((half) => 2 * half) as [number, number, number] : [1, 1, 1];
  const scale = 1 / Math.max(wide, high, deep, 1e-9), middle = (high * scale) / 2;
  const colors = COLORS.map(hex), blades = [...colors.slice(1), colors[0]!];
  let grammar = textOf(form);
  try {
    grammar = JSON.stringify(JSON.parse(grammar), null, 2).replace(/\n/g, "\n      ");
  } catch {
    // It is being typed; the program says what is wrong.
  }
  const lines = (members: [string, unknown][]): string => members.map(([name, value]) => `      ${JSON.stringify(name)}: ${spaced(value)},\n`).join("");
  return `{
  "title": ${JSON.stringify(title)},
  "version": 2,
  "seed": ${form.seed},
  "film": {"frames": 1, "size": [640, 640], "quality": "good"},
  "scene": {
    "setting": "studio",
    "camera": {"location": ${spaced([0, digits(middle), 3])}, "look_at": ${spaced([0, digits(middle), 0])}, "angle": ${ANGLE}, "fit": ["plant"], "margin": 0.1},
    "studio": {"wall": "#dfe3e0", "distance": ${digits(1.2 + deep * scale)}}
  },
  "organisms": [
    {
${lines([
    ["kind", "plant"], ["name", "plant"],
    ["place", { at: [[0, 0]], lean: 0, size_variation: 0, turn_variation: 0 }],
    ["height", high * scale > 1e-3 ? digits(high * scale) : 0], ["stand", "middle"], ["smoothing", 1],
    ["thickness", { least: 0.0002 }], ["bark", { colors }], ["blades", { colors: blades }],
  ])}      "grammar": ${grammar}
    }
  ]
}
`;
}
