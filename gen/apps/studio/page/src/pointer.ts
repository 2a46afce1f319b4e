/** Paths into a JSON document and JSON pointers, their text. */

export type Path = (string | number)[];

export const toPointer = (path: Path): string => path.map((p) => "/" + String(p).replaceAll("~", "~0").replaceAll("/", "~1")).join("");

/** Parts of digits are taken as indices of lists. */
export function fromPointer(pointer: string): Path {
  if (!pointer) return [];
  return pointer
    .slice(1)
    .split("/")
    .map((part) => (/^\d+$/.test(part) ? Number(part) : part.replaceAll("~1", "/").replaceAll("~0", "~")));
}

/** What stands there, undefined where nothing does. */
export function getAt(value: unknown, path: Path): unknown {
  let at = value;
  for (const key of path) {
    if (at === null || typeof at !== "object") return undefined;
    at = (at as Record<string | number, unknown>)[key];
  }
  return at;
}

/** Is `pointer` that of `above`, or of something in it? */
export const isWithin = (pointer: string, above: string): boolean => pointer === above || pointer.startsWith(above + "/");

export const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);
