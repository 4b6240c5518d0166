/** Pairs of colours that differ in one kind of the eye's cones alone. */

type Triple = readonly [number, number, number];

/** Linear light of sRGB to long, middle and short cones (Viénot, Brettel and Mollon 1999). */
const CONES: readonly Triple[] = [
  [17.8824, 43.5161, 4.11935],
  [3.45565, 27.1554, 3.86714],
  [0.0299566, 0.184309, 1.46709],
];

export type Missing = "protan" | "deutan";

/**
 * A colour, in linear light, that only the long (protan) or the middle cones (deutan) tell from grey
 * of `level`; `share` of what they catch is added or, if negative, taken away. An eye without those
 * cones sees the grey: an approximation, for screens and eyes differ.
 */
export function confusedWith(level: number, missing: Missing, share: number): Triple {
  const cones = CONES.map((row) => level * (row[0] + row[1] + row[2]));
  const kind = missing === "protan" ? 0 : 1;
  cones[kind] = (cones[kind] ?? 0) * (1 + share);
  return solved(CONES, cones as unknown as Triple);
}

/** The solution of three linear equations, by Cramer's rule. */
function solved(rows: readonly Triple[], right: Triple): Triple {
  const whole = determinant(rows);
  const one = (column: number) =>
    determinant(
      rows.map((row, at) => row.map((value, place) => (place === column ? right[at] : value))),
    ) / whole;
  return [one(0), one(1), one(2)];
}

function determinant(rows: readonly (readonly (number | undefined)[])[]): number {
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0] = rows.flat();
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

/** A code of sRGB for linear light, 0 to 255. */
export function code(linear: number): number {
  const inside = Math.min(1, Math.max(0, linear));
  const encoded = inside <= 0.0031308 ? 12.92 * inside : 1.055 * inside ** (1 / 2.4) - 0.055;
  return Math.round(255 * encoded);
}
