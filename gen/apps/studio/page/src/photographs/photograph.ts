/** A photograph that is worked on, and the picture that comes of it. */

import { el, pngOf } from "../dom";
import { backgroundOf, balanced, boundsOf, colorAt, flooded, largestPiece, middleOfRow, softened, upright, type Mask, type Point } from "./pixels";

const MOST_WORKED = 1200; // pixels a side of the photograph
const MOST_RESULT = 1024;

export type Half = "both" | "left" | "right";
export type Balance = "none" | "background" | "point";
export type Mark = "foot" | "tip" | "grey" | "from" | "to";

interface State {
  mask: Mask;
  marks: Partial<Record<Mark, Point>>;
  balance: Balance;
}

export class Photograph {
  readonly width: number;
  readonly height: number;
  half: Half = "both";
  private picture: ImageData;
  private states: State[];
  private made = el<HTMLCanvasElement>("canvas");

  constructor(bitmap: ImageBitmap, private what: "leaf" | "bark") {
    const scale = Math.min(1, MOST_WORKED / Math.max(bitmap.width, bitmap.height));
    this.width = Math.max(1, Math.round(bitmap.width * scale));
    this.height = Math.max(1, Math.round(bitmap.height * scale));
    const context = contextOf(el<HTMLCanvasElement>("canvas", { width: this.width, height: this.height }));
    context.drawImage(bitmap, 0, 0, this.width, this.height);
    this.picture = context.getImageData(0, 0, this.width, this.height);
    // What is transparent already was cut away before.
    this.states = [{ mask: Uint8Array.from({ length: this.width * this.height }, (_, i) => (this.picture.data[4 * i + 3]! < 128 ? 0 : 1)), marks: {}, balance: "none" }];
  }

  private get now(): State {
    return this.states.at(-1)!;
  }
  get balance(): Balance {
    return this.now.balance;
  }
  set balance(balance: Balance) {
    this.states.push({ ...this.now, balance });
  }

  inside([x, y]: Point): Point {
    return [Math.max(0, Math.min(x, this.width - 1)), Math.max(0, Math.min(y, this.height - 1))];
  }

  flood(at: Point, tolerance: number, back: boolean): void {
    this.states.push({ ...this.now, mask: flooded(this.picture, this.now.mask, at, tolerance, back ? 1 : 0) });
  }
  put(mark: Mark, at: Point): void {
    this.states.push({ ...this.now, marks: { ...this.now.marks, [mark]: at }, balance: mark === "grey" ? "point" : this.now.balance });
  }
  undo(): void {
    if (this.states.length > 1) this.states.pop();
  }

  /** The photograph with what is cut away faint, its marks and the cross. */
  draw(canvas: HTMLCanvasElement, cross: Point): void {
    const context = contextOf(canvas);
    const { mask, marks } = this.now;
    const shown = new ImageData(this.picture.data.slice(), this.width, this.height);
    mask.forEach((kept, i) => kept || (shown.data[4 * i + 3] = 30));
    context.putImageData(shown, 0, 0);
    const size = Math.max(this.width, this.height) / 60;
    context.lineWidth = size / 5;
    const mark = ([x, y]: Point, color: string): void => {
      context.strokeStyle = color;
      context.beginPath();
      for (const [dx, dy] of [[size, 0], [0, size]] as const) {
        context.moveTo(x + 0.5 - dx, y + 0.5 - dy);
        context.lineTo(x + 0.5 + dx, y + 0.5 + dy);
      }
      context.stroke();
    };
    if (this.what === "bark") {
      const [x, y, wide, high] = this.piece();
      context.strokeStyle = "#f60";
      context.strokeRect(x, y, wide, high);
    } else if (marks.foot) mark(marks.foot, "#06f");
    if (marks.tip) mark(marks.tip, "#0af");
    if (marks.grey) mark(marks.grey, "#888");
    mark(cross, "#f0f");
  }

  /** Draws what the preset gets; false where that is nothing. */
  result(shown: HTMLCanvasElement): boolean {
    const there = this.what === "leaf" ? this.leaf() : this.bark();
    [shown.width, shown.height] = there ? [this.made.width, this.made.height] : [16, 16];
    if (there) contextOf(shown).drawImage(this.made, 0, 0);
    return there;
  }

  png(): Promise<Blob> {
    return pngOf(this.made);
  }

  private grey(): [number, number, number] | null {
    const { balance, marks, mask } = this.now;
    if (balance === "point") return marks.grey ? colorAt(this.picture, marks.grey) : null;
    return balance === "background" ? backgroundOf(this.picture, mask) : null;
  }

  /** The photograph's pixels with that opacity and its colours balanced. */
  private colored(opacity?: Uint8Array): HTMLCanvasElement {
    const grey = this.grey();
    const data = grey ? balanced(this.picture.data, grey) : this.picture.data.slice();
    opacity?.forEach((o, i) => (data[4 * i + 3] = o));
    const canvas = el<HTMLCanvasElement>("canvas", { width: this.width, height: this.height });
    contextOf(canvas).putImageData(new ImageData(data as Uint8ClampedArray<ArrayBuffer>, this.width, this.height), 0, 0);
    return canvas;
  }

  private leaf(): boolean {
    const mask = largestPiece(this.now.mask, this.width, this.height);
    const bounds = boundsOf(mask, this.width);
    if (!bounds) return false;
    const { marks } = this.now;
    const foot = marks.foot ?? [middleOfRow(mask, this.width, bounds.high[1]), bounds.high[1] + 1];
    const tip = marks.tip ?? [middleOfRow(mask, this.width, bounds.low[1]), bounds.low[1]];
    if (foot[0] === tip[0] && foot[1] === tip[1]) return false;
    const stand = upright(mask, this.width, foot, tip, MOST_RESULT);
    [this.made.width, this.made.height] = [stand.width, stand.height];
    const context = contextOf(this.made);
    context.translate(...stand.foot);
    context.rotate(-stand.turn);
    context.scale(stand.scale, stand.scale);
    context.imageSmoothingQuality = "high";
    context.drawImage(this.colored(softened(mask, this.width, this.height)), -foot[0], -foot[1]);
    context.resetTransform();
    if (this.half !== "both") this.mirror(this.half);
    return true;
  }

  private mirror(from: "left" | "right"): void {
    const { width, height } = this.made;
    const copy = el<HTMLCanvasElement>("canvas", { width, height });
    contextOf(copy).drawImage(this.made, 0, 0);
    const context = contextOf(this.made);
    const left = from === "left" ? width / 2 : 0; // the other half
    context.clearRect(left, 0, width / 2, height);
    context.save();
    context.beginPath();
    context.rect(left, 0, width / 2, height);
    context.clip();
    context.translate(width, 0);
    context.scale(-1, 1);
    context.drawImage(copy, 0, 0);
    context.restore();
  }

  /** The rectangle of bark: its corner and size; all of it where it has no corners yet. */
  private piece(): [number, number, number, number] {
    const { from, to } = this.now.marks;
    const [a, b] = [from ?? [0, 0], to ?? [this.width, this.height]];
    return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1])];
  }

  private bark(): boolean {
    const [x, y, wide, high] = this.piece();
    if (wide < 16 || high < 16) return false;
    const scale = Math.min(1, MOST_RESULT / Math.max(wide, high));
    [this.made.width, this.made.height] = [Math.max(16, Math.round(wide * scale)), Math.max(16, Math.round(high * scale))];
    contextOf(this.made).drawImage(this.colored(), x, y, wide, high, 0, 0, this.made.width, this.made.height);
    return true;
  }
}

const contextOf = (canvas: HTMLCanvasElement): CanvasRenderingContext2D => canvas.getContext("2d", { willReadFrequently: true })!;
