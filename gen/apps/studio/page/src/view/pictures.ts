import { LinearFilter, LinearMipmapLinearFilter, NoColorSpace, RepeatWrapping, SRGBColorSpace, Texture, TextureLoader, Vector3, type IUniform } from "three";
import type { Tile } from "./header";

/** Pictures of a material, ready when both have come. */
export interface TilePictures {
  colors: Texture;
  normals: Texture;
  ready: { value: number };
}

function adjust(texture: Texture, color: boolean): Texture {
  texture.colorSpace = color ? SRGBColorSpace : NoColorSpace;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.anisotropy = 4;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  return texture;
}

/** Pictures of leaves and materials. What is in them never changes, so each is loaded once. */
export class Pictures {
  private loader = new TextureLoader();
  private known = new Map<string, Texture>();
  private tiles = new Map<string, TilePictures>();
  /** The server may have to render tiles: they are asked for one after the other, so that it keeps time for scenes. */
  private queue: Promise<void> = Promise.resolve();
  private disposed = false;

  constructor(
    private address: (id: string) => string,
    private come: () => void,
  ) {}

  leaf(id: string): Texture {
    let texture = this.known.get(id);
    if (!texture) {
      texture = adjust(this.loader.load(this.address(id), this.come), true);
      this.known.set(id, texture);
    }
    return texture;
  }

  /** The picture of a sky once it has come; it is asked for after the tiles that were wanted so far. */
  sky(id: string): Promise<Texture | null> {
    const known = this.known.get(id);
    if (known) return Promise.resolve(known);
    const come = this.queue.then(async () => {
      if (this.disposed) return null;
      const texture = await this.loader.loadAsync(this.address(id)).catch(() => null);
      if (!texture) return null;
      texture.colorSpace = NoColorSpace;
      texture.generateMipmaps = false;
      texture.minFilter = LinearFilter;
      texture.wrapS = RepeatWrapping;
      this.known.set(id, texture);
      return texture;
    });
    this.queue = come.then(() => undefined);
    return come;
  }

  tile({ colors, normals }: Tile): TilePictures {
    const known = this.tiles.get(colors);
    if (known) return known;
    const made = { colors: adjust(new Texture(), true), normals: adjust(new Texture(), false), ready: { value: 0 } };
    this.tiles.set(colors, made);
    this.queue = this.queue.then(async () => {
      try {
        for (const [texture, id] of [[made.colors, colors], [made.normals, normals]] as const) {
          if (this.disposed) return;
          if (!id) continue;
          texture.image = (await this.loader.loadAsync(this.address(id))).image;
          texture.needsUpdate = true;
        }
        made.ready.value = 1;
        this.come();
      } catch {
        // Without POV-Ray there are none, and colours stay plain.
      }
    });
    return made;
  }

  /** Resolves when all tiles that were asked for have come. */
  tilesReady(): Promise<void> {
    return this.queue;
  }

  dispose(): void {
    this.disposed = true;
    for (const texture of this.known.values()) texture.dispose();
    for (const { colors, normals } of this.tiles.values()) {
      colors.dispose();
      normals.dispose();
    }
    this.known.clear();
    this.tiles.clear();
  }
}

/** What shaders of things that are TILED have to know. */
export function tiled(tile: Tile, pictures: Pictures): Record<string, IUniform> {
  const { colors, normals, ready } = pictures.tile(tile);
  return {
    tile: { value: colors },
    tile_normals: { value: normals },
    tiled: ready,
    tile_wide: { value: tile.wide },
    tile_high: { value: tile.high },
    tile_light: { value: new Vector3(...tile.light) },
  };
}
