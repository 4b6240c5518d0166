/** A plot by uPlot, as wide as there is room. */

import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";

const INK = "#ececec";
const SOFT = "#b0b0b0";
const GRID = "#383838";
const FONT = "11px system-ui, sans-serif";

export interface Line {
  readonly label: string;
  readonly values: ArrayLike<number>;
  readonly dash?: readonly number[];
  readonly points?: boolean;
}

interface Given {
  /** What screen readers say of it. */
  readonly label: string;
  readonly x: ArrayLike<number>;
  readonly xLabel: string;
  readonly yLabel: string;
  readonly lines: readonly Line[];
  readonly range: { readonly x?: [number, number]; readonly y?: [number, number] };
  readonly heightPx: number;
  /** The place that is pointed at, by its number; null of none. */
  readonly hover?: (at: number | null) => void;
  /** Draws below the lines. */
  readonly under?: (plot: uPlot) => void;
}

export function Plot(given: Given) {
  const here = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const now = useRef(given);
  now.current = given;
  const { label, x, xLabel, yLabel, lines, heightPx } = given;
  const kinds = lines.map((line) => `${line.label} ${line.points ?? false}`).join();
  useEffect(() => {
    const div = here.current;
    if (div === null) return;
    const made = new uPlot(
      optionsOf(() => now.current, div.clientWidth),
      dataOf(now.current),
      div,
    );
    plot.current = made;
    const watch = new ResizeObserver(() =>
      made.setSize({ width: div.clientWidth, height: heightPx }),
    );
    watch.observe(div);
    return () => {
      watch.disconnect();
      made.destroy();
      plot.current = null;
    };
  }, [heightPx, kinds, xLabel, yLabel]);
  useEffect(
    () => plot.current?.setData(dataOf(now.current)),
    [x, ...lines.map((line) => line.values)],
  );
  return <div class="plot" ref={here} role="img" aria-label={label} />;
}

const dataOf = ({ x, lines }: Given) =>
  [Array.from(x), ...lines.map((line) => Array.from(line.values))] as uPlot.AlignedData;

function optionsOf(given: () => Given, width: number): uPlot.Options {
  const { lines, xLabel, yLabel, heightPx } = given();
  const axis = (label: string, size: number): uPlot.Axis => ({
    label,
    labelFont: FONT,
    labelSize: 16,
    font: FONT,
    size,
    gap: 3,
    stroke: SOFT,
    grid: { stroke: GRID, width: 1 },
    ticks: { stroke: GRID, width: 1, size: 4 },
  });
  return {
    width,
    height: heightPx,
    padding: [8, 8, 0, 0],
    legend: { show: false },
    cursor: { y: false, drag: { setScale: false, x: false, y: false }, points: { size: 6 } },
    scales: {
      x: { time: false, range: (_, least, most) => given().range.x ?? [least, most] },
      y: { range: (_, least, most) => given().range.y ?? roomy(least, most) },
    },
    axes: [axis(xLabel, 26), axis(yLabel, 38)],
    series: [
      {},
      ...lines.map(({ label, dash, points }, i) => ({
        label,
        stroke: i === 0 ? INK : SOFT,
        width: 1.5,
        ...(dash === undefined ? {} : { dash: [...dash] }),
        points: { show: points ?? false, size: 4, fill: INK },
      })),
    ],
    hooks: {
      setCursor: [(plot) => given().hover?.(plot.cursor.idx ?? null)],
      drawAxes: [(plot) => given().under?.(plot)],
    },
  };
}

function roomy(least: number, most: number): [number, number] {
  const room = 0.08 * (most - least || 1);
  return [least - room, most + room];
}
