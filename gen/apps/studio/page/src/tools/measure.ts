/** Metres between two places that are clicked, and above the ground. */

import { Raycaster, Vector3, type PerspectiveCamera } from "three";
import * as api from "../api";
import { el } from "../dom";
import type { Store } from "../store";
import type { Drag, Tool } from "../view/tool";
import type { View } from "../view/view";
import { Marks } from "../view/marks";

const COLOR = 0xffe14d;

export class Measure implements Tool {
  readonly drawn = new Marks();
  private told = el("p", { role: "status", "data-testid": "measured" }, "Click two places.");
  readonly options = el("div.tool-options", { "data-testid": "measure" }, this.told);
  private ends: Vector3[] = [];

  constructor(
    private store: Store,
    private view: View,
  ) {}

  click(ray: Raycaster): void {
    void this.add(ray);
  }
  drag(): Drag | null {
    return null;
  }
  scaleTo(camera: PerspectiveCamera, pixel: number): void {
    this.drawn.scaleTo(camera, pixel);
  }
  refresh(): void {
    /* Places stay where they were. */
  }
  key(event: KeyboardEvent): boolean {
    if (event.key !== "Enter") return false;
    this.click(this.view.middle());
    return true;
  }

  private async add(ray: Raycaster): Promise<void> {
    const { origin, direction } = ray.ray;
    const all = this.view.head?.entries.map((_, i) => i) ?? [];
    const sent = [...origin.toArray(), ...direction.toArray()];
    const ground = this.view.groundUnder(ray, 0);
    const [hit] = await api.trace(this.store.doc, this.store.time, [sent], all).catch(() => [null]);
    const spots = [hit ? new Vector3(...hit.at) : null, ground].filter((p) => p !== null);
    const nearest = spots.sort((a, b) => a.distanceTo(origin) - b.distanceTo(origin))[0];
    if (!nearest) {
      this.told.textContent = "Nothing is there.";
      return;
    }
    if (this.ends.length > 1) this.ends = [];
    this.ends.push(nearest);
    this.show();
  }

  private show(): void {
    this.drawn.clear();
    const [a, b] = this.ends;
    for (const end of this.ends) this.drawn.handle(end, COLOR);
    if (a && b) {
      this.drawn.line([...a.toArray(), ...b.toArray()], COLOR);
      this.told.textContent = `${metres(a.distanceTo(b))}; across ${metres(Math.hypot(b.x - a.x, b.z - a.z))}, up ${metres(b.y - a.y)}`;
    } else if (a) this.told.textContent = `${metres(a.y)} above 0. Click the other end.`;
    this.view.redraw();
  }
}

const metres = (x: number): string => (Math.abs(x) < 1 ? `${(100 * x).toFixed(1)} cm` : `${x.toFixed(2)} m`);
