import type { Header, Part } from "./header";

/** What stands for a part that is in the cache: without its arrays, which lay in another answer. */
const nameOf = ({ id, kind, entry }: Part, specimen: number): Part => ({ id, kind, entry, specimen }) as Part;

/** A picture from which organisms are missing, with these as they were before. What looks at all of them, the camera, stays. */
export function merged(was: Header, now: Header): Header {
  const missing = new Set(now.missing);
  if (!missing.size || was.entries.length !== now.entries.length) return now;
  const specimens = [...now.specimens];
  const number = new Map<number, number>();
  was.specimens.forEach((one, i) => missing.has(one.entry) && number.set(i, specimens.push(one) - 1));
  const kept = was.parts.filter((part) => missing.has(part.entry));
  return {
    ...now,
    nodes: was.nodes,
    camera: was.camera,
    entries: now.entries.map((one, i) => (missing.has(i) ? { ...was.entries[i]!, name: one.name, kind: one.kind } : one)),
    specimens,
    parts: [...now.parts, ...kept.map((part) => nameOf(part, number.get(part.specimen) ?? part.specimen))],
  };
}
