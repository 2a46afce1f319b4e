/** Vectors, sizes, ranges: a box for each number. */

import { el } from "../dom";
import type { VectorField } from "../schema";
import { valueOf, type Control, type Place } from "./control";
import { numberBox } from "./number";

const AXES = ["x", "y", "z", "w"];

function namesOf(field: VectorField, label: string): string[] {
  if (label === "size" && field.unit === "px") return ["w", "h"];
  if (/\bx, z\b|along x and z/.test(field.doc)) return ["x", "z"];
  if (/lowest|least|most/i.test(field.doc) && field.items.length === 2) return ["from", "to"];
  if (/length, height and depth/i.test(field.doc)) return ["l", "h", "d"];
  return AXES.slice(0, field.items.length);
}

/** What there is of a vector, with 0 for all that is missing. */
export const vectorOf = (value: unknown, length: number): number[] => {
  const given = Array.isArray(value) ? value : [];
  return Array.from({ length }, (_, i) => (typeof given[i] === "number" ? (given[i] as number) : 0));
};

export function vectorControl(place: Place<VectorField>): Control {
  const { field, binding, label } = place;
  const names = namesOf(field, label);
  const boxes = field.items.map((item, i) =>
    numberBox(`${label} ${names[i]}`, item, (value, done) => {
      const now = vectorOf(valueOf(place), field.items.length);
      now[i] = value;
      binding.set(now, done);
    }),
  );
  const parts = boxes.map((box, i) => el("span.boxed.named", {}, el("span.unit", {}, names[i]!), box));
  return {
    element: el("span.vector", {}, ...parts),
    refresh(): void {
      const value = valueOf(place);
      boxes.forEach((box, i) => box.show(Array.isArray(value) ? value[i] : ""));
    },
  };
}
