/** Measures as rows of a table, and as text to copy. */

import type { Measured, Measures } from "nacreous-wasm";

/** The six regions of hue, in the order of `interference`. */
export const HUES = ["red", "yellow", "green", "blueGreen", "blue", "purple"] as const;

/** What a row is called; words/instruments.ts says it. */
export type Quantity =
  | "diameter"
  | "least"
  | "greatest"
  | "roundness"
  | "lightness"
  | "chroma"
  | "hue"
  | "meanChroma"
  | "orient"
  | "score"
  | (typeof HUES)[number]
  | "lampAngle"
  | "peak"
  | "around"
  | "halfWidth"
  | "gloss"
  | "haze"
  | "distinctness"
  | "blemishArea"
  | "blemishCount"
  | "threshold";

export type Part = "shape" | "colour" | "overtone" | "lamp" | "blemishes";

export interface Row {
  readonly part: Part;
  readonly quantity: Quantity;
  readonly number: Measured;
  readonly unit: string;
  /** Digits behind the point at the least. */
  readonly digits: number;
}

type Numbers = readonly (readonly [Quantity, Measured | number | null, string, number?])[];

function rowsOf(part: Part, numbers: Numbers): Row[] {
  return numbers.flatMap(([quantity, given, unit, digits = 0]) => {
    if (given === null) return [];
    const number = typeof given === "number" ? { value: given, error: null } : given;
    return [{ part, quantity, number, unit, digits }];
  });
}

const percent = (share: Measured | null): Measured | null =>
  share === null
    ? null
    : { value: 100 * share.value, error: share.error === null ? null : 100 * share.error };

/** The rows of all that was measured. */
export function table(found: Measures): Row[] {
  const { size, colour, rings, lamp, blemishes } = found;
  const hues = HUES.map((hue, i) => [hue, rings?.interference[i] ?? null, "%", 1] as const);
  return [
    ...rowsOf("shape", [
      ["diameter", size.mean, size.unit],
      ["least", size.least, size.unit],
      ["greatest", size.greatest, size.unit],
      ["roundness", percent(found.roundness), "%"],
    ]),
    ...rowsOf("colour", [
      ["lightness", colour?.lightness ?? null, ""],
      ["chroma", colour?.chroma ?? null, ""],
      ["hue", colour?.hue_deg ?? null, "°"],
    ]),
    ...rowsOf("overtone", [
      ["meanChroma", rings?.chroma ?? null, ""],
      ["orient", rings?.orient ?? null, ""],
      ["score", rings?.interference_total ?? null, "%"],
      ...hues,
    ]),
    ...rowsOf("lamp", [
      ["lampAngle", lamp?.view_deg ?? null, "°", 1],
      ["peak", lamp?.peak ?? null, "", 3],
      ["around", lamp?.around ?? null, "", 3],
      ["halfWidth", lamp?.half_width_deg ?? null, "°"],
      ["gloss", lamp?.contrast_gloss ?? null, "%"],
      ["haze", lamp?.haze ?? null, "%"],
      ["distinctness", lamp?.distinctness ?? null, "%"],
    ]),
    ...rowsOf("blemishes", [
      ["blemishArea", blemishes?.area ?? null, "%"],
      ["blemishCount", blemishes?.count ?? null, ""],
      ["threshold", blemishes?.threshold ?? null, "L*", 1],
    ]),
  ];
}

/** Errors below this are rounding's. */
const NOISE = 1e-9;

/** A number to the second digit of its error, with it: commands/measure_lines.py `shown`. */
export function shown({ value, error }: Measured, unit: string, least = 0): string {
  const behind = unit === "°" ? "°" : unit === "" ? "" : ` ${unit}`;
  if (error === null) {
    return `${value.toFixed(Number.isInteger(value) ? least : Math.max(1, least))}${behind}`;
  }
  const wanted = error > NOISE ? 1 - Math.floor(Math.log10(error)) : 1;
  const digits = Math.min(Math.max(wanted, least, 0), 4);
  return `${value.toFixed(digits)} ± ${error.toFixed(digits)}${behind}`;
}

/** Lines with tabs between, as tables take them; numbers in full. */
export function lines(rows: readonly (readonly (string | number | null)[])[]): string {
  return rows.map((row) => row.map((cell) => cell ?? "").join("\t")).join("\n");
}
