/** The scale as a drawing: a row a stimulus, with its picture, its place and its interval. */

import { pictureAt, type Placed, type Scale } from "../api";

const NS = "http://www.w3.org/2000/svg";
const ROW = 72;
const DENSE_ROW = 40;
/** From so many stimuli on, rows are lower. */
const DENSE = 13;
const AXIS = 54;
const TOP = 12;
const VALUE = 64;
const RIGHT = 4;
/** What dots and an arrow take beside the outermost place. */
const ARROW = 28;

type Attributes = Record<string, string | number>;

function shape(name: string, attributes: Attributes, ...children: (Node | string)[]): SVGElement {
  const made = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  made.append(...children);
  return made;
}

export interface Captions {
  /** What the drawing shows, for those who cannot see it. */
  alt: string;
  axis: string;
  /** Written over simulated answers; empty for people's. */
  mark: string;
}

/** Numbers a round step apart that lie within the bounds; about as many as are asked for. */
export function ticks(low: number, high: number, about: number): number[] {
  const rough = (high - low) / about;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((times) => times * power).find((one) => one >= rough) ?? rough;
  const found: number[] = [];
  for (let at = Math.ceil(low / step); at * step <= high + step / 1e6; at += 1)
    found.push(at * step);
  return found;
}

/** A number with a true minus sign, never minus nothing. */
export function numeral(value: number, digits = 2): string {
  const text = Math.abs(value).toFixed(digits);
  return value < 0 && Number(text) !== 0 ? `\u2212${text}` : text;
}

/** The drawing at a width in CSS pixels. */
export function chart(scale: Scale, width: number, captions: Captions): SVGElement {
  const rows = scale.stimuli;
  const height = rows.length < DENSE ? ROW : DENSE_ROW;
  const thumb = height - 10;
  const longest = Math.max(...rows.map((row) => row.label.length));
  const gutter = thumb + 20 + Math.min(Math.max(24, longest * 9), width * 0.24);
  const low = Math.min(...rows.map((row) => row.low ?? row.value));
  const high = Math.max(...rows.map((row) => row.high ?? row.value));
  const pad = 0.04 * (high - low) || 1;
  const inside = width - gutter - VALUE - RIGHT;
  const left = rows.some((row) => row.low === null) ? ARROW : 0;
  const right = rows.some((row) => row.high === null) ? ARROW : 0;
  const x = (value: number) =>
    gutter + left + ((value - low + pad) / (high - low + 2 * pad)) * (inside - left - right);
  const bottom = TOP + rows.length * height;
  const svg = shape("svg", {
    class: captions.mark === "" ? "chart" : "chart simulated",
    role: "img",
    "aria-label": captions.alt,
    width,
    height: bottom + AXIS,
    viewBox: `0 0 ${width} ${bottom + AXIS}`,
  });
  if (captions.mark !== "") {
    const middle = { x: gutter + inside / 2, y: (TOP + bottom) / 2 };
    svg.append(shape("text", { class: "mark", ...middle }, captions.mark));
  }
  const step = ticks(low - pad, high + pad, Math.max(3, inside / 110));
  const digits = (step[1] ?? 1) - (step[0] ?? 0) < 0.1 ? 2 : 1;
  for (const tick of step) {
    const zero = Math.abs(tick) < 1e-9;
    svg.append(
      shape("line", {
        class: zero ? "zero" : "grid",
        x1: x(tick),
        x2: x(tick),
        y1: TOP,
        y2: bottom,
      }),
      shape("text", { class: "tick", x: x(tick), y: bottom + 20 }, numeral(tick, digits)),
    );
  }
  svg.append(
    shape("text", { class: "axis", x: gutter + inside / 2, y: bottom + 44 }, captions.axis),
    ...rows.map((row, place) =>
      line(row, TOP + (place + 0.5) * height, x, { thumb, gutter, width, inside }),
    ),
  );
  return svg;
}

function line(
  row: Placed,
  y: number,
  x: (value: number) => number,
  {
    thumb,
    gutter,
    width,
    inside,
  }: { thumb: number; gutter: number; width: number; inside: number },
): SVGElement {
  const clip = Math.max(3, Math.floor((gutter - thumb - 20) / 9));
  const label = row.label.length > clip ? `${row.label.slice(0, clip - 1)}…` : row.label;
  return shape(
    "g",
    {},
    shape("image", {
      href: pictureAt(row.picture),
      x: 0,
      y: y - thumb / 2,
      width: thumb,
      height: thumb,
      preserveAspectRatio: "xMidYMid slice",
    }),
    shape("text", { class: "label", x: thumb + 12, y: y + 5 }, label),
    ...interval(row, y, x, { from: gutter + 2, to: gutter + inside - 6 }),
    shape("circle", { class: "place", cx: x(row.value), cy: y, r: 7 }),
    shape("text", { class: "value", x: width - RIGHT, y: y + 5 }, numeral(row.value)),
  );
}

/** The bar; where the answers set no end to it, dots go on to an arrow at the drawing's edge. */
function interval(
  { value, low, high }: Placed,
  y: number,
  x: (value: number) => number,
  edge: { from: number; to: number },
): SVGElement[] {
  const bar = shape("line", {
    class: "interval",
    x1: x(low ?? value),
    x2: x(high ?? value),
    y1: y,
    y2: y,
  });
  const gone = [
    ...(low === null ? [{ end: edge.from, side: -1 }] : []),
    ...(high === null ? [{ end: edge.to, side: 1 }] : []),
  ];
  const open = gone.flatMap(({ end, side }) => [
    shape("line", { class: "unset", x1: x(value), x2: end, y1: y, y2: y }),
    shape("path", {
      class: "unset",
      d: `M${end - side * 7},${y - 6} L${end},${y} l${-side * 7},6`,
    }),
  ]);
  return [bar, ...open];
}
