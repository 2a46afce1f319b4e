import { LinearMipmapLinearFilter, RepeatWrapping, SRGBColorSpace, TextureLoader, type Texture } from "three";

/** Pictures of leaves. What is in them never changes, so each is loaded once. */
export class LeafPictures {
  private loader = new TextureLoader();
  private known = new Map<string, Texture>();

  constructor(
    private address: (id: string) => string,
    private come: () => void,
  ) {}

  texture(id: string): Texture {
    let texture = this.known.get(id);
    if (!texture) {
      texture = this.loader.load(this.address(id), this.come);
      texture.colorSpace = SRGBColorSpace;
      texture.minFilter = LinearMipmapLinearFilter;
      texture.anisotropy = 4;
      texture.wrapS = texture.wrapT = RepeatWrapping;
      this.known.set(id, texture);
    }
    return texture;
  }

  dispose(): void {
    for (const texture of this.known.values()) texture.dispose();
    this.known.clear();
  }
}
