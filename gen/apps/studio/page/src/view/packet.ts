import type { BlobRef, Header } from "./header";

/** An answer of the server taken apart: its header and where its arrays lie. */
export interface Packet {
  header: Header;
  bytes: ArrayBuffer;
  /** Where the arrays begin. */
  base: number;
}

const MAGIC = 0x314e5246; // "FRN1"

/** Throws where the bytes are no picture of a model. */
export function decode(answer: ArrayBuffer): Packet {
  const view = new DataView(answer);
  if (answer.byteLength < 8 || view.getUint32(0, true) !== MAGIC) throw new Error("the answer is no picture of the model");
  const length = view.getUint32(4, true);
  if (length % 8 || 8 + length > answer.byteLength) throw new Error("the picture of the model is cut off");
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(answer, 8, length))) as Header;
  return { header, bytes: answer, base: 8 + length };
}

const WIDTH = { f32: 4, u32: 4, i8: 1, u8: 1 };

function place(packet: Packet, blob: BlobRef, type: BlobRef["t"]): [ArrayBuffer, number, number] {
  const at = packet.base + blob.at;
  if (blob.t !== type || at + blob.n * WIDTH[type] > packet.bytes.byteLength) throw new Error("the picture of the model is cut off");
  return [packet.bytes, at, blob.n];
}

// Views, not copies.
export const floats = (packet: Packet, blob: BlobRef): Float32Array => new Float32Array(...place(packet, blob, "f32"));
export const words = (packet: Packet, blob: BlobRef): Uint32Array => new Uint32Array(...place(packet, blob, "u32"));
export const bytes = (packet: Packet, blob: BlobRef): Uint8Array => new Uint8Array(...place(packet, blob, "u8"));
export const signedBytes = (packet: Packet, blob: BlobRef): Int8Array => new Int8Array(...place(packet, blob, "i8"));
