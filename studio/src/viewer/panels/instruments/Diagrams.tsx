/** Colour by angle, the profile of the lamp's image, chromaticity. */

import type { Measures } from "nacreous-wasm";
import { useMemo, useState } from "preact/hooks";
import type uPlot from "uplot";
import type { Chart, Found } from "../../light/instruments";
import { chart, found, isFresh } from "../../state/instruments";
import { lines } from "../../state/measured";
import { type Spot, closeUp, endOf, middleOf, pairs, spotOf } from "../../state/wheel";
import { say } from "../../words/instruments";
import { Plot } from "./Plot";
import { Head, copy } from "./Point";

export function Diagrams() {
  const made = found.value;
  if (made?.measures == null) return null;
  return (
    <div class={isFresh.value ? "" : "stale"}>
      <HueRings found={made} measures={made.measures} />
      <Profile measures={made.measures} />
      {chart.value !== null && <Chromaticity chart={chart.value} xy={made.xy} />}
    </div>
  );
}

function HueRings({ found, measures }: { found: Found; measures: Measures }) {
  const rings = measures.rings?.rings ?? [];
  if (rings.length === 0) return null;
  const code = (i: number) =>
    `rgb(${[0, 1, 2].map((channel) => found.ringCodes[4 * i + channel] ?? 0).join(" ")})`;
  return (
    <section class="instrument">
      <Head title={say("hueRings")} />
      <p class="says">{say("hueRingsAbout")}</p>
      <div class="pair">
        <svg viewBox="-1 -1 2 2" class="diagram" aria-hidden="true">
          {rings
            .map((ring, i) => (
              <g key={i}>
                <path d={half(ring.to, -1)} fill={code(2 * i)} />
                <path d={half(ring.to, 1)} fill={code(2 * i + 1)} />
              </g>
            ))
            .reverse()}
        </svg>
        <Wheel measures={measures} />
      </div>
    </section>
  );
}

/** Half of a disc. */
const half = (radius: number, side: 1 | -1) =>
  `M0 ${-radius}A${radius} ${radius} 0 0 ${side === 1 ? 1 : 0} 0 ${radius}Z`;

function Wheel({ measures }: { measures: Measures }) {
  const rings = measures.rings?.rings ?? [];
  const end = endOf(rings.map((ring) => ring.colour?.chroma.value ?? 0));
  const spots = rings.map((ring) => spotOf(ring, end)).filter((spot) => spot !== null);
  const [first] = spots;
  return (
    <svg viewBox="-1.3 -1.3 2.6 2.6" class="diagram wheel" role="img" aria-label={say("hueWheel")}>
      <circle r={1} class="grid" />
      <circle r={0.5} class="grid" />
      <path d="M-1 0H1M0 -1V1" class="grid" />
      {["+a*", "+b*"].map((name, i) => (
        <text key={name} x={i === 0 ? 1.15 : 0} y={i === 0 ? 0.05 : -1.07}>
          {name}
        </text>
      ))}
      <text x={0.72} y={0.98} class="start">
        C* {end}
      </text>
      <polyline class="course" points={spots.map(({ x, y }) => `${x},${-y}`).join(" ")} />
      {spots.map(({ x, y }, i) => (
        <circle key={i} cx={x} cy={-y} r={0.035} class="node" />
      ))}
      {first !== undefined && <circle cx={first.x} cy={-first.y} r={0.065} class="node first" />}
      {[...new Set([rings[0], rings.at(-1)])].map((ring) => {
        const spot = ring === undefined ? null : spotOf(ring, end);
        if (ring === undefined || spot === null) return null;
        return (
          <text key={ring.view_deg} x={spot.x} y={-spot.y - 0.11} class="angle">
            {ring.view_deg.toFixed(0)}°
          </text>
        );
      })}
    </svg>
  );
}

function Profile({ measures: { lamp } }: { measures: Measures }) {
  const [at, setAt] = useState<number | null>(null);
  const series = useMemo(
    () => ({
      x: lamp?.profile.map(([degrees]) => degrees) ?? [],
      light: lamp?.profile.map(([, light]) => light) ?? [],
    }),
    [lamp],
  );
  if (lamp === null || series.x.length < 2) return null;
  const copies = () => copy(lines([["degrees", "luminance"], ...lamp.profile]));
  const [x, y] = at === null ? [] : [series.x[at], series.light[at]];
  const under = (plot: uPlot) => {
    const place = plot.valToPos(lamp.half_width_deg.value, "x", true);
    plot.ctx.fillStyle = "#6a6a6a";
    plot.ctx.fillRect(place, plot.bbox.top, 1, plot.bbox.height);
  };
  return (
    <section class="instrument">
      <Head title={say("profile")} copies={copies} />
      <p class="says">{say("profileAbout")}</p>
      <p class="readout">
        {x === undefined || y === undefined ? (
          `${say("halfWidth")} ${lamp.half_width_deg.value.toFixed(2)}°`
        ) : (
          <output>
            {x.toFixed(2)}° · {y.toFixed(3)}
          </output>
        )}
      </p>
      <Plot
        label={say("profilePlot")}
        x={series.x}
        xLabel={`${say("angle")}, °`}
        yLabel={say("luminance")}
        lines={[{ label: "Y", values: series.light }]}
        range={{ x: [0, series.x.at(-1) ?? 1], y: [0, 1.05 * Math.max(...series.light)] }}
        heightPx={170}
        hover={setAt}
        under={under}
      />
    </section>
  );
}

const WHOLE = { x: -0.02, y: -0.02, side: 0.9 };

function Chromaticity({ chart, xy }: { chart: Chart; xy: Float32Array }) {
  const [isClose, setClose] = useState(false);
  const spots = useMemo(() => pairs(xy), [xy]);
  const white = pairs(chart.srgb)[3] ?? { x: 0, y: 0 };
  const { x, y, side } = isClose ? closeUp(spots, white) : WHOLE;
  const at = (spot: Spot) => `${(spot.x - x) / side} ${1 - (spot.y - y) / side}`;
  const path = (corners: readonly Spot[]) => `M${corners.map(at).join("L")}Z`;
  const mean = middleOf(spots);
  const dots = spots.filter((one) => Number.isFinite(one.x + one.y));
  return (
    <section class="instrument">
      <Head
        title={say("chromaticity")}
        copies={() => copy(lines([["x", "y"], ...dots.map((one) => [one.x, one.y])]))}
      />
      <p class="says">{say("chromaticityAbout")}</p>
      <p class="readout">
        {mean !== null && (
          <output>
            x {mean.x.toFixed(4)} · y {mean.y.toFixed(4)}
          </output>
        )}
        <button
          type="button"
          class="link"
          aria-pressed={isClose}
          onClick={() => setClose(!isClose)}
        >
          {say(isClose ? "whole" : "closer")}
        </button>
      </p>
      <svg
        viewBox="-0.12 -0.02 1.14 1.12"
        class="diagram chart"
        role="img"
        aria-label={say("chromaticity")}
      >
        <clipPath id="chart-frame">
          <path d="M0 0H1V1H0Z" />
        </clipPath>
        <path d="M0 0H1V1H0Z" class="frame" />
        <Scale from={x} side={side} isUp={false} />
        <Scale from={y} side={side} isUp={true} />
        <g clip-path="url(#chart-frame)">
          <path d={path(pairs(chart.locus))} class="locus" />
          <path d={path(pairs(chart.p3).slice(0, 3))} class="gamut p3" />
          <path d={path(pairs(chart.srgb).slice(0, 3))} class="gamut" />
          <path d={dots.map((one) => `M${at(one)}h0`).join("")} class="dots" />
          <path d={`M${at(white)}m-0.02 0h0.04m-0.02 -0.02v0.04`} class="white" />
        </g>
      </svg>
    </section>
  );
}

/** Numbers along a side of the chart. */
function Scale({ from, side, isUp }: { from: number; side: number; isUp: boolean }) {
  const step = [0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2].find((one) => side / one <= 5.5) ?? 0.2;
  const first = Math.ceil(from / step - 1e-9);
  const marks = Array.from({ length: 7 }, (_, i) => (first + i) * step).filter(
    (one) => one <= from + side,
  );
  const digits = step < 0.01 ? 3 : step < 0.1 ? 2 : 1;
  return (
    <>
      {marks.map((one) => {
        const place = (one - from) / side;
        return isUp ? (
          <g key={one}>
            <path d={`M0 ${1 - place}H1`} class="grid" />
            <text x={-0.012} y={1 - place + 0.012} class="end">
              {one.toFixed(digits)}
            </text>
          </g>
        ) : (
          <g key={one}>
            <path d={`M${place} 0V1`} class="grid" />
            <text x={place} y={1.05}>
              {one.toFixed(digits)}
            </text>
          </g>
        );
      })}
      <text x={isUp ? -0.05 : 0.97} y={isUp ? 0.03 : 1.095}>
        {isUp ? "y" : "x"}
      </text>
    </>
  );
}
