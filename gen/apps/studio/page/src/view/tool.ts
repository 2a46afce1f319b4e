import type { Group, PerspectiveCamera, Raycaster } from "three";

/** What a pointer that is held down does. */
export interface Drag {
  move(ray: Raycaster, shift: boolean): void;
  end(): void;
}

/** What the pointer does in the view in place of selecting organisms. */
export interface Tool {
  /** Drawn over the picture. */
  readonly drawn: Group;
  click(ray: Raycaster): void;
  /** The pointer is there, with no button held; null: it has left the view. */
  hover?(ray: Raycaster | null): void;
  /** What a drag that begins there does; null: it turns the eye. */
  drag(ray: Raycaster): Drag | null;
  /** Keeps its handles of one size on the screen; `pixel`: metres that a pixel covers a metre away. */
  scaleTo(camera: PerspectiveCamera, pixel: number): void;
}
