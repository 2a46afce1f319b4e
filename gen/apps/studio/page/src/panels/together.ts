/** Plantings that are dragged over the ground, or moved by keys: with several organisms selected all of these go as far. */

import { Binding } from "../controls/binding";
import type { Path } from "../pointer";
import { round } from "../rounding";
import type { Store } from "../store";

type Spot = [number, number];
interface Stand {
  path: Path;
  at: Spot;
}

const isSpot = (value: unknown): value is Spot => Array.isArray(value) && typeof value[0] === "number" && typeof value[1] === "number";

/** Where an organism stands: at places, and about the middle of the ring that the others are scattered in. */
function standsOf(store: Store, entry: number): Stand[] {
  const organism = store.preset.organism(entry);
  const places = new Binding(store, entry, ["place", "at"]);
  const list = places.get();
  const at = (Array.isArray(list) ? (list as unknown[]) : []).flatMap((spot, i): Stand[] => (isSpot(spot) ? [{ path: places.item(i).path, at: spot }] : []));
  if (at.length >= Number(organism.count ?? 1) || organism.sown !== undefined) return at;
  const middle = new Binding(store, entry, ["place", "center"]);
  const center = middle.get();
  return [...at, { path: middle.path, at: isSpot(center) ? center : [0, 0] }];
}

export interface Together {
  /** The planting at a place of an organism's list is now at x, z. */
  to(entry: number, index: number, x: number, z: number, done: boolean): void;
  /** All that is selected goes so far. */
  by(x: number, z: number): void;
}

export function together(store: Store): Together {
  let begun: { stands: Stand[]; from: Spot } | null = null;
  const put = (stands: Stand[], dx: number, dz: number, gesture = ""): void =>
    store.change(stands.reduce((text, { path, at }) => store.edited(text, path, [round(at[0] + dx), round(at[1] + dz)]), store.text), gesture);
  return {
    to(entry, index, x, z, done): void {
      if (!begun) {
        const meant = store.meant(entry);
        const held = standsOf(store, entry).find(({ path }) => path.at(-2) === "at" && path.at(-1) === index);
        if (!held) return;
        begun = { stands: meant.length > 1 ? meant.flatMap((one) => standsOf(store, one)) : [held], from: held.at };
      }
      put(begun.stands, x - begun.from[0], z - begun.from[1], "placed");
      if (!done) return;
      begun = null;
      store.endGesture();
    },
    by(x, z): void {
      put(store.chosen.flatMap((one) => standsOf(store, one)), x, z);
    },
  };
}
