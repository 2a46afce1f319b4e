import { DataTexture, NearestFilter, RGBAFormat, RGBAIntegerFormat, RGFormat, RedIntegerFormat, FloatType, UnsignedByteType, UnsignedIntType, type PixelFormat, type TextureDataType } from "three";
import { owned } from "./drawn";

/** Arrays as textures, for vertex shaders that look up what is theirs: many small things in one drawing each would cost
 *  far more. `PER_ROW` things in a row. */
export const PER_ROW = 512;

type Numbers = Float32Array | Uint32Array | Uint8Array;

/** A view of `data` made long enough for whole rows; what lies behind it is never looked at. */
function whole<T extends Numbers>(data: T, length: number): T {
  if (data.length === length) return data;
  const Kind = data.constructor as new (...given: unknown[]) => T;
  if (data.byteOffset + length * data.BYTES_PER_ELEMENT <= data.buffer.byteLength) return new Kind(data.buffer, data.byteOffset, length);
  const copy = new Kind(length);
  copy.set(data);
  return copy;
}

function texture(data: Numbers, texelsEach: number, channels: number, format: PixelFormat, type: TextureDataType, internal: string): DataTexture {
  const rows = Math.max(1, Math.ceil(data.length / (channels * texelsEach * PER_ROW)));
  const width = texelsEach * PER_ROW;
  const made = new DataTexture(whole(data, rows * width * channels) as Float32Array<ArrayBuffer>, width, rows, format, type);
  made.internalFormat = internal as never;
  made.minFilter = made.magFilter = NearestFilter;
  made.generateMipmaps = false;
  made.flipY = false;
  made.unpackAlignment = 4;
  made.needsUpdate = true;
  return owned(made);
}

/** Lets go of the answer's bytes once they are on the graphics card. */
function released(made: DataTexture): DataTexture {
  made.onUpdate = () => {
    made.source.data = { width: made.image.width, height: made.image.height, data: null };
    made.onUpdate = null;
  };
  return made;
}

/** 48 bytes each: three texels of four whole numbers. */
export const segmentsTexture = (data: Uint32Array): DataTexture => released(texture(data, 3, 4, RGBAIntegerFormat, UnsignedIntType, "RGBA32UI"));
/** Ten numbers each. */
export const placesTexture = (data: Float32Array): DataTexture => released(texture(data, 5, 2, RGFormat, FloatType, "RG32F"));
/** Four bytes each. */
export const paintsTexture = (data: Uint8Array): DataTexture => released(texture(data, 1, 4, RGBAFormat, UnsignedByteType, "RGBA8"));
/** One whole number each; it stays, to be written again. */
export const orderTexture = (count: number): DataTexture => texture(new Uint32Array(Math.max(1, Math.ceil(count / PER_ROW)) * PER_ROW), 1, 1, RedIntegerFormat, UnsignedIntType, "R32UI");
