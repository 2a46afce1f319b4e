/** RGBA bytes from the lowest row up as a PNG's address. */
export function addressOf(pixels: Uint8Array, width: number, height: number): string {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const pen = canvas.getContext("2d")!;
  const image = pen.createImageData(width, height);
  for (let y = 0; y < height; ++y) image.data.set(pixels.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
  pen.putImageData(image, 0, 0);
  return canvas.toDataURL("image/png");
}
