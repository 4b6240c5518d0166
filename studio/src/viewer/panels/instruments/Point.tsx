/** Spectra at the point, and the layers of its pearl with their days. */

import { useMemo, useState } from "preact/hooks";
import type uPlot from "uplot";
import { WAVELENGTH_NM } from "../../light/instruments";
import { type Layer, outer } from "../../state/growing";
import { copyNumbers, layers, reading, trouble } from "../../state/instruments";
import { lines } from "../../state/measured";
import { say } from "../../words/instruments";
import { refusalSays } from "../../words/refusals";
import { Said } from "../Said";
import { Plot } from "./Plot";

export function copy(text: string): void {
  void copyNumbers(text, { done: say("copied"), not: say("notCopied") });
}

/** Wavelengths, R and T at the point, under their angle. */
export function copySpectra(): void {
  const read = reading.value;
  if (read?.film == null) return;
  const { R, T } = read.film;
  const rows = Array.from(WAVELENGTH_NM, (nm, i) => [nm, R[i] ?? null, T[i] ?? null]);
  copy(lines([["angle_deg", (read.angleRad * 180) / Math.PI], ["nm", "R", "T"], ...rows]));
}

export function degrees(rad: number): string {
  return ((rad * 180) / Math.PI).toFixed(1);
}

const percents = (shares: Float64Array) => Array.from(shares, (share) => 100 * share);

export function Point() {
  const read = reading.value;
  const [at, setAt] = useState<number | null>(null);
  const film = read?.film ?? null;
  const both = useMemo(
    () => (film === null ? null : { R: percents(film.R), T: percents(film.T) }),
    [film],
  );
  return (
    <section class="instrument">
      <Head title={say("point")} {...(film === null ? {} : { copies: copySpectra })} />
      <p class="says">{say("pointAbout")}</p>
      {trouble.value !== "" && (
        <p class="nothing">
          <Said {...refusalSays(trouble.value)} />
        </p>
      )}
      {read === null && <p class="nothing">{say("beside")}</p>}
      {read != null && (
        <p class="readout">
          {say("viewAngle")}{" "}
          <output data-column={read.column} data-row={read.row}>
            {degrees(read.angleRad)}°
          </output>
          {both !== null && at !== null && (
            <span>
              {WAVELENGTH_NM[at]} nm · R {both.R[at]?.toFixed(2)} % · T {both.T[at]?.toFixed(2)} %
            </span>
          )}
        </p>
      )}
      {read != null && film === null && (
        <p class="nothing">
          {say("noFilm")} <Said {...refusalSays(read.why)} />
        </p>
      )}
      {both !== null && (
        <>
          <Plot
            label={say("spectraPlot")}
            x={WAVELENGTH_NM}
            xLabel="nm"
            yLabel="%"
            lines={[
              { label: "R", values: both.R },
              { label: "T", values: both.T, dash: [5, 4] },
            ]}
            range={{ x: [380, 780], y: [0, 100] }}
            heightPx={190}
            hover={setAt}
          />
          <p class="keys">
            <span class="key solid">{say("reflected")}</span>
            <span class="key dashed">{say("transmitted")}</span>
          </p>
          <p class="says">{say("exact")}</p>
        </>
      )}
    </section>
  );
}

/** Each layer's thickness over its depth, with its day where it grew. */
export function LayersPlot() {
  const known = layers.value;
  const [isFilm, setFilm] = useState(false);
  const filmUm = known?.filmUm ?? Infinity;
  const shown = useMemo(
    () => (known === null ? [] : outer(known, isFilm ? filmUm : Infinity)),
    [known, isFilm, filmUm],
  );
  const series = useMemo(
    () => ({ x: shown.map((one) => one.depthUm), nm: shown.map((one) => one.thicknessNm) }),
    [shown],
  );
  const [at, setAt] = useState<number | null>(null);
  const one = at === null ? undefined : shown[at];
  if (known === null || shown.length === 0) return null;
  const all = () =>
    copy(
      lines([
        ["depth_um", "thickness_nm", "date"],
        ...shown.map(({ depthUm, thicknessNm, date }) => [depthUm, thicknessNm, date]),
      ]),
    );
  return (
    <section class="instrument">
      <Head title={say("layers")} copies={all} />
      <p class="says">{say(known.grown === null ? "layersListed" : "layersAbout")}</p>
      <p class="readout">
        {one === undefined ? (
          say("count", {
            n: shown.length,
            least: Math.min(...series.nm).toFixed(0),
            most: Math.max(...series.nm).toFixed(0),
          })
        ) : (
          <output>
            {one.date !== "" && <>{one.date} · </>}
            {one.thicknessNm.toFixed(1)} nm · {one.depthUm.toFixed(2)} µm
          </output>
        )}
        {known.filmUm !== null && (
          <button type="button" class="link" aria-pressed={isFilm} onClick={() => setFilm(!isFilm)}>
            {say(isFilm ? "allNacre" : "filmAlone")}
          </button>
        )}
      </p>
      <Plot
        label={say("layersPlot")}
        x={series.x}
        xLabel={`${say("depth")}, µm`}
        yLabel="nm"
        lines={[{ label: "nm", values: series.nm, points: shown.length <= FEW }]}
        range={{}}
        heightPx={180}
        hover={setAt}
        under={(plot) => shade(plot, shown, filmUm)}
      />
    </section>
  );
}

/** So many layers are shown as dots too. */
const FEW = 200;

/** Marks where the film ends, and lays a lighter ground under each layer, the more the more summery its day was. */
function shade(plot: uPlot, shown: readonly Layer[], filmUm: number): void {
  const { ctx, bbox } = plot;
  ctx.save();
  for (const [i, { depthUm, warmth }] of shown.entries()) {
    const before = shown[i - 1]?.depthUm ?? depthUm;
    const after = shown[i + 1]?.depthUm ?? depthUm;
    const left = plot.valToPos((before + depthUm) / 2, "x", true);
    const right = plot.valToPos((depthUm + after) / 2, "x", true);
    ctx.fillStyle = `rgb(255 255 255 / ${14 * warmth}%)`;
    ctx.fillRect(left, bbox.top, right - left, bbox.height);
  }
  const last = shown.at(-1)?.depthUm ?? 0;
  if (filmUm < last) {
    ctx.fillStyle = "#8a8a8a";
    ctx.fillRect(plot.valToPos(filmUm, "x", true), bbox.top, 1, bbox.height);
  }
  ctx.restore();
}

export function Head({ title, copies }: { title: string; copies?: () => void }) {
  return (
    <div class="head">
      <h2>{title}</h2>
      {copies !== undefined && (
        <button type="button" class="link" onClick={copies} aria-label={`${say("copy")}: ${title}`}>
          {say("copy")}
        </button>
      )}
    </div>
  );
}
