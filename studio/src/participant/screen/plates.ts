/** Discs of dots in which a digit differs from the rest in one kind of cones alone, drawn by us. */

import { element } from "../../shared/dom";
import { chance } from "./chance";
import { code, confusedWith } from "./confusion";
import type { Missing } from "./confusion";

interface Plate {
  digit: number;
  /** "any": the digit is brighter as well, so that everybody sees it. */
  kind: Missing | "any";
  seed: number;
}

const SIDE_PX = 340;
const DOTS = 1500;
export const LEVEL = 0.24;
/** How much of the cones' catch the digit differs in. */
export const SHARES: Record<Missing, number> = { protan: 0.18, deutan: 0.16 };
/** Dots differ in brightness by chance, so that brightness does not tell the digit. */
export const SPREAD = 0.35;

/** One for everybody, then three for each kind of cones, each with another digit. */
export function platesOf(seed: number): Plate[] {
  const next = chance(seed);
  const digits = [2, 3, 4, 5, 6, 7, 8, 9].sort(() => next() - 0.5);
  const kinds = ["any", "protan", "deutan", "deutan", "protan", "protan", "deutan"] as const;
  return kinds.map((kind, place) => ({
    kind,
    digit: digits[place] ?? 2,
    seed: seed * 16 + place,
  }));
}

/** Draw a plate on a new canvas. */
export function plate(shown: Plate): HTMLCanvasElement {
  const side = Math.round(SIDE_PX * devicePixelRatio);
  const canvas = element("canvas", { width: side, height: side, class: "plate" });
  const pen = canvas.getContext("2d");
  const inside = digit(shown.digit, side);
  if (pen === null) return canvas;
  for (const dot of packed(chance(shown.seed + 1))) {
    const x = dot.x * side;
    const y = dot.y * side;
    pen.fillStyle = colour(shown, inside(x, y), dot.chance);
    pen.beginPath();
    pen.arc(x, y, dot.radius * side, 0, 2 * Math.PI);
    pen.fill();
  }
  return canvas;
}

/** Rest and digit lie on either side of grey, so that the digit is no dot brighter on the whole. */
function colour(shown: Plate, inside: boolean, by: number): string {
  const kind = shown.kind === "any" ? "deutan" : shown.kind;
  const brighter = shown.kind === "any" && inside ? 1.9 : 1;
  const level = LEVEL * brighter * (1 + SPREAD * (2 * by - 1));
  const light = confusedWith(level, kind, inside ? -SHARES[kind] : SHARES[kind]);
  return `rgb(${light.map(code).join(" ")})`;
}

interface Dot {
  x: number;
  y: number;
  radius: number;
  chance: number;
}

/** Dots of many sizes in a disc, none over another: thrown at it, and kept where there is room. */
function packed(next: () => number): Dot[] {
  const dots: Dot[] = [];
  for (let tries = 0; dots.length < DOTS && tries < 12_000; tries += 1) {
    const largest = 0.02 - 0.014 * Math.min(1, tries / 4000);
    const [x, y] = [next(), next()];
    if (Math.hypot(x - 0.5, y - 0.5) > 0.49 - largest) continue;
    let room = largest;
    for (const dot of dots) {
      room = Math.min(room, Math.hypot(dot.x - x, dot.y - y) - dot.radius - 0.002);
      if (room < 0.005) break;
    }
    if (room >= 0.005) dots.push({ x, y, radius: room, chance: next() });
  }
  return dots;
}

/** Tells whether a place is inside a large digit. */
function digit(shown: number, side: number): (x: number, y: number) => boolean {
  const mask = element("canvas", { width: side, height: side });
  const pen = mask.getContext("2d", { willReadFrequently: true });
  if (pen === null) return () => false;
  pen.font = `bold ${Math.round(side * 0.72)}px Arial, Helvetica, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(String(shown), side / 2, side * 0.53);
  const { data } = pen.getImageData(0, 0, side, side);
  return (x, y) => (data[4 * (Math.floor(y) * side + Math.floor(x)) + 3] ?? 0) > 127;
}
