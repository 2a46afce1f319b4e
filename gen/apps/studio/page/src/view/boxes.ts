import { Box3, Vector3 } from "three";
import type { Header, Vec3 } from "./header";

/** From where one looks at a thing: a little aside of straight above, where the eye has no up. */
export const SIDES = { front: [0, 0, 1], side: [1, 0, 0], top: [0, 1, 1e-3] } satisfies Record<string, Vec3>;

/** What an organism takes; empty where there is none of it. */
export const boxOf = (entry: Header["entries"][number] | undefined): Box3 =>
  entry && entry.specimens + entry.copies > 0 ? new Box3(new Vector3(...entry.low), new Vector3(...entry.high)) : new Box3();

/** What all that is looked at takes: of a wide stand only what is near can be told apart. */
export function boundsOf({ entries, camera }: Header): Box3 {
  const box = new Box3();
  for (const entry of entries) box.union(boxOf(entry));
  const middle = new Vector3(...camera.to);
  const far = Math.max(8, 2.5 * middle.distanceTo(new Vector3(...camera.at)));
  const near = new Box3().setFromCenterAndSize(middle, new Vector3(2 * far, 4 * far, 2 * far));
  return box.intersectsBox(near) ? box.intersect(near).expandByScalar(0.05) : box;
}
