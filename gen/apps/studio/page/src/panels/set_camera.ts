/** Puts the preset's camera where somebody looks from. */

import { vectorOf } from "../controls/vector";
import { setAt } from "../edits";
import { keysOf, valueAtTime, withKey } from "../keyframes";
import { getAt, isObject } from "../pointer";
import { round, rounded } from "../rounding";
import type { Store } from "../store";
import type { Vec3 } from "../view/header";

/** As a whole, or as a key at the time shown where it moves, or is to move. */
export function setCamera(store: Store, at: Vec3, to: Vec3, asKey = false): void {
  const camera = getAt(store.preset.whole, ["scene", "camera"]);
  const said = isObject(camera) ? camera : {};
  // Where a move goes on from these, they are where it begins.
  if (isObject(said.move) && (said.move.orbit || said.move.rail)) store.setTime(0);
  const eye = rounded(at);
  const was = store.scene.header?.camera;
  // Heights of a camera that follows the land count from the ground, which we know below the camera as it was.
  if (said.follow === true && was) eye[1] = round(eye[1] - was.at[1] + Number(vectorOf(valueAtTime(said.location, store.time), 3)[1]));
  const value = (name: string, v: Vec3, before: Vec3 | undefined): unknown => {
    const keys = keysOf(said[name]);
    if (!keys && !asKey) return v;
    const first = said[name] ?? (before && rounded(before));
    return withKey(keys ?? (store.time > 0 && first ? [[0, first]] : []), store.time, v);
  };
  store.batch((text) => {
    const moved = setAt(text, ["scene", "camera", "location"], value("location", eye, was?.at));
    return setAt(moved, ["scene", "camera", "look_at"], value("look_at", rounded(to), was?.to));
  });
}
