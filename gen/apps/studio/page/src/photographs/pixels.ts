/** What is done to a photograph: background cut away, the leaf turned upright, its colours balanced. */

/** Bytes of red, green, blue and opacity, rows from the top down; ImageData is one. */
export interface Pixels {
  width: number;
  height: number;
  data: Uint8ClampedArray;
}
export type Point = [number, number];
/** 1 where a pixel is kept, 0 where it is cut away. */
export type Mask = Uint8Array;

/** The mean colour of a pixel and its eight neighbours, so that noise counts little. */
export function colorAt({ width, height, data }: Pixels, [x, y]: Point): [number, number, number] {
  const sum: [number, number, number] = [0, 0, 0];
  let count = 0;
  for (let j = Math.max(0, y - 1); j <= Math.min(height - 1, y + 1); j++)
    for (let i = Math.max(0, x - 1); i <= Math.min(width - 1, x + 1); i++, count++) for (let c = 0; c < 3; c++) sum[c]! += data[4 * (j * width + i) + c]!;
  return sum.map((s) => s / count) as [number, number, number];
}

/** Visits what is connected with `at` by its sides, as long as `joins`. */
function flood(width: number, height: number, at: number, joins: (i: number) => boolean, visit: (i: number) => void): void {
  const seen = new Uint8Array(width * height);
  const waiting = [at];
  seen[at] = 1;
  while (waiting.length) {
    const i = waiting.pop()!;
    visit(i);
    const x = i % width;
    const y = (i - x) / width;
    for (const [k, inside] of [[i - 1, x > 0], [i + 1, x + 1 < width], [i - width, y > 0], [i + width, y + 1 < height]] as const)
      if (inside && !seen[k] && joins(k)) {
        seen[k] = 1;
        waiting.push(k);
      }
  }
}

/** The mask with what has the colour there, within `tolerance` of 0 to 255, cut away or put back as far as it is connected. */
export function flooded(picture: Pixels, mask: Mask, at: Point, tolerance: number, keep: 0 | 1): Mask {
  const { width, height, data } = picture;
  const [red, green, blue] = colorAt(picture, at);
  const made = mask.slice();
  const joins = (i: number): boolean => Math.hypot(data[4 * i]! - red, data[4 * i + 1]! - green, data[4 * i + 2]! - blue) <= tolerance;
  flood(width, height, at[1] * width + at[0], joins, (i) => (made[i] = keep));
  return made;
}

/** The largest piece of what is kept, without holes of a few pixels: what noise left behind goes. */
export function largestPiece(mask: Mask, width: number, height: number): Mask {
  const MOST_HOLE = 64;
  const made = new Uint8Array(mask.length);
  const known = new Uint8Array(mask.length);
  let largest: number[] = [];
  const holes: number[][] = [];
  for (let at = 0; at < mask.length; at++) {
    if (known[at]) continue;
    const piece: number[] = [];
    flood(width, height, at, (i) => mask[i] === mask[at], (i) => {
      known[i] = 1;
      piece.push(i);
    });
    if (!mask[at]) piece.length <= MOST_HOLE && holes.push(piece);
    else if (piece.length > largest.length) largest = piece;
  }
  for (const i of largest) made[i] = 1;
  // A hole lies in the piece when its first pixel, whose left neighbour is kept, touches it.
  for (const hole of holes) if (hole[0]! % width > 0 && made[hole[0]! - 1]) for (const i of hole) made[i] = 1;
  return made;
}

/** The box of what is kept: the first and the last column and row. Null where nothing is. */
export function boundsOf(mask: Mask, width: number): { low: Point; high: Point } | null {
  const low: Point = [Infinity, Infinity];
  const high: Point = [-1, -1];
  mask.forEach((kept, i) => {
    if (!kept) return;
    const at = [i % width, Math.floor(i / width)];
    for (const c of [0, 1] as const) {
      low[c] = Math.min(low[c], at[c]!);
      high[c] = Math.max(high[c], at[c]!);
    }
  });
  return high[0] < 0 ? null : { low, high };
}

/** Middle of what is kept in a row. */
export function middleOfRow(mask: Mask, width: number, y: number): number {
  const kept = [...mask.subarray(y * width, (y + 1) * width).keys()].filter((x) => mask[y * width + x]);
  return kept.length ? kept[kept.length >> 1]! : width >> 1;
}

/** The opacity of a mask, with soft edges. */
export function softened(mask: Mask, width: number, height: number): Uint8Array {
  const made = new Uint8Array(mask.length);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      let sum = 0;
      for (let k = 0; k < 9; k++) {
        const [i, j] = [x - 1 + (k % 3), y - 1 + Math.floor(k / 3)];
        if (i >= 0 && j >= 0 && i < width && j < height) sum += mask[j * width + i]!;
      }
      // A pixel that was cut away shows the background, so it stays away.
      made[y * width + x] = mask[y * width + x] ? Math.round((255 * sum) / 9) : 0;
    }
  return made;
}

/** The mean colour of what was cut away; null where nothing was. */
export function backgroundOf({ data }: Pixels, mask: Mask): [number, number, number] | null {
  const sum: [number, number, number] = [0, 0, 0];
  let count = 0;
  mask.forEach((kept, i) => {
    if (kept) return;
    count++;
    for (let c = 0; c < 3; c++) sum[c]! += data[4 * i + c]!;
  });
  return count ? (sum.map((s) => s / count) as [number, number, number]) : null;
}

const linear = (v: number): number => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
const encoded = (v: number): number => (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);

/** The colours as they would be if `grey` had none, as bright as before. */
export function balanced(data: Uint8ClampedArray, grey: [number, number, number]): Uint8ClampedArray {
  const light = grey.map((c) => Math.max(linear(c / 255), 1e-3));
  const mean = (light[0]! + light[1]! + light[2]!) / 3;
  const curves = light.map((l) => Uint8ClampedArray.from({ length: 256 }, (_, v) => 255 * encoded(Math.min(1, (linear(v / 255) * mean) / l))));
  return data.map((v, i) => (i % 4 < 3 ? curves[i % 4]![v]! : v));
}

/** How a leaf comes to stand upright: its turn, its scale, and the size of its picture, with the foot in the middle. */
export interface Upright {
  turn: number;
  scale: number;
  width: number;
  height: number;
  /** Where the foot is in it. */
  foot: Point;
}
export function upright(mask: Mask, width: number, foot: Point, tip: Point, most: number): Upright {
  const turn = Math.atan2(tip[0] - foot[0], foot[1] - tip[1]);
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  let [half, top, bottom] = [1, 0, 0];
  mask.forEach((kept, i) => {
    if (!kept) return;
    const [x, y] = [(i % width) - foot[0], Math.floor(i / width) - foot[1]];
    half = Math.max(half, Math.abs(x * c + y * s) + 1);
    top = Math.min(top, y * c - x * s);
    bottom = Math.max(bottom, y * c - x * s + 1);
  });
  const scale = Math.min(1, most / Math.max(2 * half, bottom - top));
  const size = (length: number): number => Math.max(16, Math.ceil(length * scale));
  return { turn, scale, width: size(2 * half), height: size(bottom - top), foot: [(size(2 * half)) / 2, -top * scale] };
}
