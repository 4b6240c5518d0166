/** Colours for numbers: lighter is more, for every kind of colour vision (nine stops of viridis). */

export const FALSE_COLOURS: readonly (readonly [number, number, number])[] = [
  [68, 1, 84],
  [71, 44, 122],
  [59, 81, 139],
  [44, 113, 142],
  [33, 144, 141],
  [39, 173, 129],
  [92, 200, 99],
  [170, 220, 50],
  [253, 231, 37],
];

/** Codes RGBA of numbers from 0 to `most`; what is beyond has the last colour. */
export function falseColours(values: Float32Array, most: number): Uint8ClampedArray<ArrayBuffer> {
  const codes = new Uint8ClampedArray(values.length * 4);
  const last = FALSE_COLOURS.length - 1;
  values.forEach((value, i) => {
    const place = Math.max(0, Math.min(1, value / most)) * last;
    const below = Math.min(last - 1, Math.floor(place));
    const [from, to] = [FALSE_COLOURS[below], FALSE_COLOURS[below + 1]];
    for (const channel of [0, 1, 2] as const) {
      const [a, b] = [from?.[channel] ?? 0, to?.[channel] ?? 0];
      codes[i * 4 + channel] = a + (b - a) * (place - below);
    }
    codes[i * 4 + 3] = 255;
  });
  return codes;
}
