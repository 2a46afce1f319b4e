import { Raycaster } from "three";

/** The pointer's own is used again. */
export const copied = (ray: Raycaster): Raycaster => new Raycaster(ray.ray.origin.clone(), ray.ray.direction.clone());
