/** Lines and handles that are drawn over the picture. */

import { BufferAttribute, BufferGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, SphereGeometry, Vector3, type PerspectiveCamera } from "three";

const HANDLE = 6; // pixels
const ball = new SphereGeometry(1, 12, 8);

const over = { depthTest: false, transparent: true };
const paints = new Map<number, MeshBasicMaterial>();

function paintOf(color: number): MeshBasicMaterial {
  const paint = paints.get(color) ?? new MeshBasicMaterial({ color, ...over });
  paints.set(color, paint);
  return paint;
}

/** Where a place is in the window; `near`: before the eye. */
export type ToPixel = (at: Vector3) => { x: number; y: number; near: boolean };

/** Handles, lines and loose segments of one colour each. */
export class Marks extends Group {
  private handles: Mesh[] = [];

  clear(): this {
    for (const one of this.children)
      if (one instanceof Line) {
        one.geometry.dispose();
        (one.material as LineBasicMaterial).dispose();
      }
    this.handles = [];
    return super.clear();
  }

  /** Points x, y, z in turn. */
  line(points: ArrayLike<number>, color: number, opacity = 0.9): void {
    this.put(new Line(geometry(points), new LineBasicMaterial({ color, opacity, ...over })));
  }

  /** Pairs of such points. */
  segments(points: ArrayLike<number>, color: number, opacity = 0.6): void {
    this.put(new LineSegments(geometry(points), new LineBasicMaterial({ color, opacity, ...over })));
  }

  handle(at: Vector3, color: number): void {
    const one = new Mesh(ball, paintOf(color));
    one.position.copy(at);
    this.handles.push(one);
    this.put(one);
  }

  /** The number of the handle that is drawn nearest to a pixel; -1: none is near enough to be meant. */
  nearest(x: number, y: number, toPixel: ToPixel): number {
    let best = -1;
    let least = HANDLE + 5;
    this.handles.forEach(({ position }, i) => {
      const p = toPixel(position);
      const away = Math.hypot(p.x - x, p.y - y);
      if (!p.near || away >= least) return;
      least = away;
      best = i;
    });
    return best;
  }

  scaleTo(camera: PerspectiveCamera, pixel: number): void {
    for (const one of this.handles) one.scale.setScalar(HANDLE * pixel * one.position.distanceTo(camera.position));
    this.updateMatrixWorld();
  }

  private put(one: Line | Mesh): void {
    one.frustumCulled = false;
    one.renderOrder = this.children.length;
    this.add(one);
  }
}

function geometry(points: ArrayLike<number>): BufferGeometry {
  return new BufferGeometry().setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
}

/** Is a point within reach of a ray, as a handle drawn there is? */
export function touches(ray: { distanceToPoint(p: Vector3): number; origin: Vector3 }, at: Vector3, pixel: number): boolean {
  return ray.distanceToPoint(at) < 2 * HANDLE * pixel * at.distanceTo(ray.origin);
}
