/** Which organisms are another since the last picture of all, where nothing else is. */

import type { Preset } from "./preset";

export interface GrownFrom {
  /** All but the organisms, as text. */
  rest: string;
  /** What counts for each. */
  organisms: string[];
}

/** What of a preset no picture depends on. */
const SILENT = new Set(["organisms", "defaults", "force", "title", "$schema", "base"]);
/** More at a time are as good as all. */
const FEW = 4;

/** The name of its group is of no picture either. */
const counting = ({ group, ...rest }: Record<string, unknown>): unknown => rest;

export function grownFrom(preset: Preset): GrownFrom {
  const rest = Object.entries(preset.whole).filter(([name]) => !SILENT.has(name));
  return { rest: JSON.stringify(rest), organisms: preset.organisms.map((_, i) => JSON.stringify([counting(preset.ownOf(i)), preset.speciesName(i)])) };
}

/** None where all may be another. */
export function changedOrganisms(was: GrownFrom | null, now: GrownFrom): number[] {
  if (!was || was.rest !== now.rest || was.organisms.length !== now.organisms.length) return [];
  const changed = now.organisms.flatMap((text, i) => (text === was.organisms[i] ? [] : [i]));
  return changed.length <= FEW ? changed : [];
}
