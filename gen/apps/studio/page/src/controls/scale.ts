/** How a slider's way, 0..1, is spread over its range: evenly, or by ratio where the range spans decades. */

import type { NumberField } from "../schema";

export interface Scale {
  toValue(way: number): number;
  toWay(value: number): number;
  /** Steps of the whole way. */
  steps: number;
  low: number;
  high: number;
}

const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));

/** To so many digits that a step of the slider still shows. */
export function rounded(value: number, step: number): number {
  if (!Number.isFinite(value)) return 0;
  if (step >= 1) return Math.round(value);
  const digits = clamp(Math.ceil(-Math.log10(step)), 0, 9);
  return Number(value.toFixed(digits));
}

/** What no slider is any good for: seeds, limits of memory. */
export const isBoundless = (field: NumberField): boolean => !Number.isFinite(field.high - field.low) || (field.integer && field.high >= 1e7);

/** From 0 up with `middle` half way: fine below it, wide above it. */
function fromZero(high: number, middle: number): Pick<Scale, "toValue" | "toWay"> {
  const c = (middle * middle) / (high - 2 * middle);
  const span = Math.log1p(high / c);
  return { toValue: (way) => c * Math.expm1(way * span), toWay: (value) => Math.log1p(Math.max(0, value) / c) / span };
}

export function scaleOf(field: NumberField): Scale {
  const { low, high, integer } = field;
  const bounds = { low, high, steps: integer && high - low <= 1000 ? high - low : 1000 };
  const given = Math.abs(Number(field.default ?? 0));
  if (low > 0 && high / low >= 1000) {
    const span = Math.log(high / low);
    return { ...bounds, steps: 1000, toValue: (way) => low * Math.exp(way * span), toWay: (v) => Math.log(clamp(v, low, high) / low) / span };
  }
  const middle = given || Math.min(1, high / 100);
  if (low === 0 && high > 12 * middle && !(integer && high <= 100))
    return { ...bounds, ...fromZero(high, middle), steps: 1000 };
  if (low < 0 && low === -high && high > 12 * middle && high > 360) {
    const half = fromZero(high, middle);
    return {
      ...bounds,
      steps: 1000,
      toValue: (way) => Math.sign(way - 0.5) * half.toValue(Math.abs(2 * way - 1)),
      toWay: (value) => 0.5 + 0.5 * Math.sign(value) * half.toWay(Math.abs(value)),
    };
  }
  return { ...bounds, toValue: (way) => low + way * (high - low), toWay: (value) => clamp((value - low) / (high - low), 0, 1) };
}

/** A range is wide where it goes beyond so many times of what is usual; a slider reaches so many times that. */
const WIDE = 8;
const REACH = 3;

/** What a slider reaches of a range that is far wider than what one wants of it: about as far as the default and the value
 *  let think. Turns and shares have all of theirs. */
export function usualScale(field: NumberField, value: number): Scale {
  const { low, high, integer, unit } = field;
  const given = Math.max(Math.abs(Number(field.default ?? 0)) || 0, Math.abs(value) || 0);
  const usual = Math.max(given || Math.min(1, high / 100), integer ? 5 : 0);
  const whole = high <= 1 || (unit === "°" && high <= 360) || high <= WIDE * usual;
  if (whole || isBoundless(field)) return scaleOf(field);
  const round = (x: number): number => (integer ? Math.round(x) : Number(x.toPrecision(2)));
  const narrow = { low: low < 0 ? Math.max(low, -round(REACH * usual)) : low, high: Math.min(high, round(REACH * usual)) };
  const span = narrow.high - narrow.low;
  return {
    ...narrow,
    steps: integer && span <= 1000 ? span : 1000,
    toValue: (way) => narrow.low + way * span,
    toWay: (v) => clamp((v - narrow.low) / span, 0, 1),
  };
}

/** The value at a place of the slider, with no more digits than it can tell apart there. */
export function valueAt(scale: Scale, field: NumberField, way: number): number {
  if (way <= 0) return scale.low;
  if (way >= 1) return scale.high;
  const value = scale.toValue(way);
  const near = Math.abs(scale.toValue(Math.min(1, way + 1 / scale.steps)) - value);
  return clamp(field.integer ? Math.round(value) : rounded(value, near / 2), field.low, field.high);
}
