/** Sizes of pictures in the film's own shape. */

/** Pixels of a side that the server takes. */
const LEAST = 16;
const MOST = 8192;

/** "film", "half", "double", or so many pixels wide. */
export function sizeFor(name: string, [w, h]: [number, number]): [number, number] {
  const scale = { film: 1, half: 0.5, double: 2 }[name] ?? Number(name) / w;
  const fits = Math.min(scale, MOST / Math.max(w, h));
  return [Math.max(LEAST, Math.round(w * fits)), Math.max(LEAST, Math.round(h * fits))];
}
