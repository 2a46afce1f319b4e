import { Quaternion, Vector3 } from "three";

const TURNS = 24;

/**
 * A limb (x y z r of its nodes) that is held at its foot and pulled at node `at` to `target`, as gen/growth/pruning bends it: each
 * segment turns by as much as M/r^4 asks, M growing evenly from the pull to the foot, until the node is there or as near as its
 * length lets it come. What lies beyond is turned along. Lengths stay.
 */
export function bent(beam: readonly number[], at: number, target: Vector3): Vector3[] {
  const nodes = Array.from({ length: beam.length / 4 }, (_, i) => new Vector3(beam[4 * i], beam[4 * i + 1], beam[4 * i + 2]));
  const lengths = nodes.map((p, i) => (i ? p.distanceTo(nodes[i - 1]!) : 0));
  const reach = lengths.map((_, i) => lengths.slice(i + 1, at + 1).reduce((sum, l) => sum + l, 0));
  const soft = reach.map((far, i) => (i < at ? (far * (lengths[i + 1] ?? 0)) / beam[4 * i + 3]! ** 4 : 0));
  const most = Math.max(...soft);
  if (!(most > 0)) return nodes;
  const turn = new Quaternion();
  for (let k = 0; k < TURNS; ++k)
    for (let i = 0; i < at; ++i) {
      const here = nodes[at]!.clone().sub(nodes[i]!).normalize();
      const there = target.clone().sub(nodes[i]!).normalize();
      turn.setFromUnitVectors(here, there);
      turn.slerpQuaternions(new Quaternion(), turn, 0.5 * (soft[i]! / most));
      for (let j = i + 1; j < nodes.length; ++j) nodes[j]!.sub(nodes[i]!).applyQuaternion(turn).add(nodes[i]!);
    }
  return nodes;
}
