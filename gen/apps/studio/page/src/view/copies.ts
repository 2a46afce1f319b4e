import { Box3, Frustum, Group, Matrix4, Vector3, type DataTexture, type PerspectiveCamera } from "three";
import type { CopiesPart } from "./header";
import type { Drawn, Studio } from "./drawn";
import { placed, placesOf, shapeOf } from "./mesh";
import { bytes, floats, type Packet } from "./packet";
import { orderTexture } from "./texels";

/** Copies in one block, which is looked at as one. */
const BLOCK = 64;
/** Those of so few pixels, from foot to farthest tip, are left out. */
const SMALLEST = 1.5;
/** They are sorted anew when the eye has gone this share of the way to what it looks at, or has turned so far. */
const MOVED = 0.04;
const TURNED = 0.06;
/** Radians seen beyond the edges of the picture, so that small turns show nothing new. */
const MARGIN = 0.12;

interface Level {
  grain: number;
  order: DataTexture;
  drawn: Drawn[];
  count: number;
}

interface Block {
  box: Box3;
  /** Its copies: from one place in `sequence` to another. */
  from: number;
  to: number;
}

/** A stand of copies of one model: each is drawn as finely as its distance asks for. */
export class Stand extends Group {
  private levels: Level[] = [];
  private shadow: Level | null = null;
  private blocks: Block[] = [];
  private sequence = new Uint32Array(0);
  private feet = new Float32Array(0);
  private sortedFrom = new Vector3(Infinity, 0, 0);
  private sortedWay = new Vector3();
  private sortedPixel = 0;
  private toSun = false;
  private reach = 0;

  constructor(packet: Packet, part: CopiesPart, studio: Studio) {
    super();
    this.matrixAutoUpdate = false;
    if (!part.levels?.length || !part.instances) return;
    const data = floats(packet, part.instances);
    const places = placesOf(data, part.tints ? bytes(packet, part.tints) : null, true);
    let reach = 0;
    const make = (level: (typeof part.levels & object)[number]): Level => {
      const order = orderTexture(places.count);
      const drawn = level.parts.flatMap((p) => {
        const shape = shapeOf(packet, p);
        reach = Math.max(reach, shape?.reach ?? 0);
        return shape ? [placed([{ shape, size: 0 }], p.material, places, studio, order)] : [];
      });
      return { grain: level.grain, order, drawn, count: 0 };
    };
    this.levels = part.levels.map(make);
    this.shadow = make(part.levels.at(-1)!);
    for (const level of this.levels) for (const d of level.drawn) d.casts = false;
    // Of a level without a shape, as of a plant that is nothing from afar, there is nothing to add.
    for (const one of [...this.levels, this.shadow].flatMap((level) => level.drawn)) this.add(one);
    this.reach = reach;
    this.lay(data, reach);
    this.listForSun();
    this.forSun(false);
  }

  drawn(): Drawn[] {
    return this.children as Drawn[];
  }

  get triangles(): number {
    return this.drawn().reduce((sum, one) => (one.visible ? sum + one.triangles : sum), 0);
  }

  /** Puts neighbours together: copies in the order of a grid of cells, then cut into blocks. */
  private lay(data: Float32Array, reach: number): void {
    const count = data.length / 10;
    this.feet = new Float32Array(3 * count);
    const low = new Vector3(Infinity, 0, Infinity);
    const high = new Vector3(-Infinity, 0, -Infinity);
    for (let i = 0; i < count; ++i) {
      for (let k = 0; k < 3; ++k) this.feet[3 * i + k] = data[10 * i + k]!;
      low.set(Math.min(low.x, data[10 * i]!), 0, Math.min(low.z, data[10 * i + 2]!));
      high.set(Math.max(high.x, data[10 * i]!), 0, Math.max(high.z, data[10 * i + 2]!));
    }
    const cells = Math.max(1, Math.floor(Math.sqrt(count / BLOCK)));
    const cell = (i: number): number => {
      const along = (k: 0 | 2, from: number, to: number): number => Math.min(cells - 1, Math.floor(((this.feet[3 * i + k]! - from) / Math.max(to - from, 1e-6)) * cells));
      return along(0, low.x, high.x) * cells + along(2, low.z, high.z);
    };
    const cellOf = Uint32Array.from({ length: count }, (_, i) => cell(i));
    this.sequence = Uint32Array.from({ length: count }, (_, i) => i).sort((a, b) => cellOf[a]! - cellOf[b]! || a - b);
    for (let from = 0; from < count; ) {
      let to = from;
      const box = new Box3();
      let largest = 0;
      const corner = new Vector3();
      for (; to < count && cellOf[this.sequence[to]!] === cellOf[this.sequence[from]!]; ++to) {
        const i = this.sequence[to]!;
        box.expandByPoint(corner.fromArray(this.feet, 3 * i));
        largest = Math.max(largest, data[10 * i + 7]!, data[10 * i + 8]!, data[10 * i + 9]!);
      }
      this.blocks.push({ box: box.expandByScalar(largest * reach), from, to });
      from = to;
    }
  }

  /** The sun sees all of them, coarsely. */
  private listForSun(): void {
    const list = this.shadow!;
    (list.order.image.data as Uint32Array).set(this.sequence);
    list.order.needsUpdate = true;
    for (const d of list.drawn) d.count = this.sequence.length;
  }

  /** Whether the pass that comes is the sun's. */
  forSun(on: boolean): void {
    this.toSun = on;
    for (const level of this.levels) for (const d of level.drawn) d.visible = !on && level.count > 0;
    for (const d of this.shadow?.drawn ?? []) d.visible = on;
  }

  /** Picks the level of each copy for a camera, where that has moved much. `pixel`: metres that a pixel covers a metre away. */
  sort(camera: PerspectiveCamera, pixel: number): void {
    if (!this.levels.length) return;
    const eye = camera.position;
    camera.getWorldDirection(way);
    const near = Math.max(1, this.nearest(eye));
    const still = eye.distanceTo(this.sortedFrom) < MOVED * near && way.angleTo(this.sortedWay) < TURNED;
    if (still && Math.abs(pixel - this.sortedPixel) < 0.05 * pixel) return;
    this.sortedFrom.copy(eye);
    this.sortedWay.copy(way);
    this.sortedPixel = pixel;
    widened(camera, frustum);
    for (const level of this.levels) level.count = 0;
    for (const block of this.blocks) if (frustum.intersectsBox(block.box)) this.list(block, eye, pixel);
    for (const level of this.levels) {
      level.order.needsUpdate = true;
      for (const d of level.drawn) d.count = level.count;
    }
    this.forSun(this.toSun);
  }

  private nearest(eye: Vector3): number {
    let least = Infinity;
    for (const block of this.blocks) least = Math.min(least, block.box.distanceToPoint(eye));
    return least;
  }

  private list(block: Block, eye: Vector3, pixel: number): void {
    for (let at = block.from; at < block.to; ++at) {
      const i = this.sequence[at]!;
      const covered = pixel * Math.hypot(this.feet[3 * i]! - eye.x, this.feet[3 * i + 1]! - eye.y, this.feet[3 * i + 2]! - eye.z);
      if (this.reach < SMALLEST * covered) continue;
      let k = 0;
      while (k + 1 < this.levels.length && this.levels[k + 1]!.grain <= covered) ++k;
      const level = this.levels[k]!;
      (level.order.image.data as Uint32Array)[level.count++] = i;
    }
  }

  dispose(): void {
    for (const d of this.drawn()) d.dispose();
    this.clear();
  }
}

const way = new Vector3();
const frustum = new Frustum();
const matrix = new Matrix4();

/** What a camera sees, and a margin round it. */
function widened(camera: PerspectiveCamera, result: Frustum): void {
  const wider = (e: number): number => e / (Math.tan(Math.min(1.4, Math.atan(1 / e) + MARGIN)) * e);
  matrix.copy(camera.projectionMatrix);
  matrix.elements[0] = wider(matrix.elements[0]!);
  matrix.elements[5] = wider(matrix.elements[5]!);
  result.setFromProjectionMatrix(matrix.multiply(camera.matrixWorldInverse));
}
