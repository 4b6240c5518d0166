/** What this screen can show. */

import type { Space } from "nacreous-wasm";

/** Wide screens get their own codes; all others those of sRGB. */
export function screenSpace(): Space {
  return matchMedia("(color-gamut: p3)").matches ? "display-p3" : "srgb";
}

/** Draws codes as they are, byte for byte. */
export function put(
  canvas: HTMLCanvasElement,
  codes: Uint8ClampedArray<ArrayBuffer>,
  widthPx: number,
  space: Space,
): void {
  if (canvas.width !== widthPx || canvas.height !== widthPx) {
    canvas.width = canvas.height = widthPx;
  }
  const context = canvas.getContext("2d", { colorSpace: space, alpha: false });
  context?.putImageData(new ImageData(codes, widthPx, widthPx, { colorSpace: space }), 0, 0);
}
