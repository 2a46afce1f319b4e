import { Vector3 } from "three";
import type { ToPixel } from "./marks";

const SPACE = "http://www.w3.org/2000/svg";

/** A line in the world that is drawn over the view as a line of the page: it costs no picture. */
export class Trace {
  readonly element = document.createElementNS(SPACE, "svg");
  private line = document.createElementNS(SPACE, "polyline");
  private points: Vector3[] = [];

  constructor() {
    this.element.setAttribute("class", "trace");
    this.element.setAttribute("aria-hidden", "true");
    this.element.append(this.line);
  }

  /** Three numbers a point; none takes it away. */
  show(points: readonly number[]): void {
    this.points = Array.from({ length: points.length / 3 }, (_, i) => new Vector3(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
  }

  /** Where it is in the window now. */
  place(toPixel: ToPixel): void {
    const seen = this.points.map(toPixel).filter(({ near }) => near);
    this.line.setAttribute("points", seen.map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(" "));
  }
}
