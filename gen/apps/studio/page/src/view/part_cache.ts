import type { Part } from "./header";
import { Stand } from "./copies";
import { Drawn, type Studio } from "./drawn";
import { mesh } from "./mesh";
import type { Packet } from "./packet";
import { tubes } from "./tubes";

/** What a part has become. */
export interface Kept {
  thing: Drawn | Stand | null;
  /** Its arrays, in bytes. */
  size: number;
}

const MOST = 256 * 1024 * 1024;

/** The bytes of a part's arrays. */
function sizeOf(value: unknown): number {
  if (typeof value !== "object" || value === null) return 0;
  const blob = value as { n?: number; t?: string; at?: number };
  if (typeof blob.n === "number" && blob.t !== undefined && blob.at !== undefined) return blob.n * (blob.t === "f32" || blob.t === "u32" ? 4 : 1);
  return Object.values(value).reduce((sum: number, inner) => sum + sizeOf(inner), 0);
}

/** The parts of the last answers, made ready; the server sends those that are here by their name alone. The one that was
 *  not asked for the longest goes first, what is shown never. */
export class PartCache {
  private kept = new Map<string, Kept>();
  private size = 0;

  constructor(private studio: Studio) {}

  names(): string[] {
    return [...this.kept.keys()];
  }

  /** Each part of an answer, in its order. */
  take(packet: Packet): Kept[] {
    const shown = packet.header.parts.map((part) => {
      const kept = this.kept.get(part.id) ?? this.make(packet, part);
      // Those asked for last stand last.
      this.kept.delete(part.id);
      this.kept.set(part.id, kept);
      return kept;
    });
    const used = new Set(shown);
    for (const [id, kept] of this.kept) {
      if (this.size <= MOST) break;
      if (used.has(kept)) continue;
      this.kept.delete(id);
      this.size -= kept.size;
      kept.thing?.dispose();
    }
    return shown;
  }

  clear(): void {
    for (const { thing } of this.kept.values()) thing?.dispose();
    this.kept.clear();
    this.size = 0;
  }

  private make(packet: Packet, part: Part): Kept {
    const thing = part.kind === "tubes" ? tubes(packet, part, this.studio) : part.kind === "copies" ? new Stand(packet, part, this.studio) : mesh(packet, part, this.studio);
    const kept = { thing, size: sizeOf(part) };
    this.size += kept.size;
    return kept;
  }
}
