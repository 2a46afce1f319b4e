/** Numbers as presets have them when something was dragged: millimetres, if nothing else is said. */

import type { Vec3 } from "./view/header";

export const round = (x: number, digits = 3): number => Number(x.toFixed(digits));
export const rounded = (v: Vec3): Vec3 => v.map((x) => round(x)) as Vec3;
