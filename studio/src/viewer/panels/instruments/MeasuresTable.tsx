/** What was measured in the picture at rest, as a table. */

import type { MeasuredRing, Measures } from "nacreous-wasm";
import { found, isDrawn, isFresh } from "../../state/instruments";
import { type Part, type Row, lines, shown, table } from "../../state/measured";
import { type InstrumentWord, say } from "../../words/instruments";
import { refusalSays } from "../../words/refusals";
import { Said } from "../Said";
import { Head, copy } from "./Point";

const PARTS: readonly Part[] = ["shape", "colour", "overtone", "lamp", "blemishes"];

/** What is refused, as the table calls it. */
const REFUSED: Readonly<Record<string, InstrumentWord>> = {
  roundness: "roundness",
  colour: "colour",
  rings: "rings",
  lamp: "lamp",
  "lamp.haze": "haze",
  "lamp.distinctness": "distinctness",
  blemishes: "blemishes",
  "blemishes.relief": "relief",
};

export function MeasuresTable() {
  const made = found.value;
  if (made === null) return <Waiting />;
  const { measures, why } = made;
  if (measures === null) {
    return (
      <section class="instrument">
        <Head title={say("measures")} />
        <p class="nothing">
          <Said {...refusalSays(why)} />
        </p>
      </section>
    );
  }
  const rows = table(measures);
  return (
    <section class="instrument" data-fresh={isFresh.value}>
      <Head title={say("measures")} copies={() => copy(asText(rows, measures))} />
      <p class="says">{say(isFresh.value ? "measuresAbout" : "measuring")}</p>
      <label class="check drawing">
        <input
          type="checkbox"
          checked={isDrawn.value}
          onChange={(event) => (isDrawn.value = event.currentTarget.checked)}
        />
        {say("drawn")}
      </label>
      <div class={isFresh.value ? "tables" : "tables stale"}>
        {PARTS.map((part) => (
          <PartTable key={part} part={part} rows={rows.filter((row) => row.part === part)} />
        ))}
        <Rings rings={measures.rings?.rings ?? []} />
        <Refused measures={measures} />
      </div>
    </section>
  );
}

function Waiting() {
  return (
    <section class="instrument">
      <Head title={say("measures")} />
      <p class="says">{say("measuring")}</p>
    </section>
  );
}

/** All numbers in full: quantity, value, error, unit; then the rings; then what is refused. */
function asText(rows: readonly Row[], { rings, refused }: Measures): string {
  const colours = (rings?.rings ?? []).map(({ view_deg, colour }, i) => [
    `ring ${i + 1}`,
    view_deg,
    colour?.lightness.value ?? null,
    colour?.chroma.value ?? null,
    colour?.hue_deg?.value ?? null,
  ]);
  return lines([
    ["quantity", "value", "error", "unit"],
    ...rows.map(({ quantity, number, unit }) => [quantity, number.value, number.error, unit]),
    ["ring", "view_deg", "lightness", "chroma", "hue_deg"],
    ...colours,
    ...refused.map(({ quantity, reason }) => ["refused", quantity, reason]),
  ]);
}

function PartTable({ part, rows }: { part: Part; rows: readonly Row[] }) {
  if (rows.length === 0) return null;
  return (
    <table class="numbers">
      <caption>{say(part)}</caption>
      <tbody>
        {rows.map(({ quantity, number, unit, digits }) => {
          const value = shown(number, unit, digits);
          const name = say(quantity);
          return (
            <tr key={quantity}>
              <th scope="row">{name}</th>
              <td>
                <button
                  type="button"
                  class="value"
                  data-quantity={quantity}
                  aria-label={say("copyOne", { name, value })}
                  onClick={() => copy(value)}
                >
                  {value}
                </button>
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function Rings({ rings }: { rings: readonly MeasuredRing[] }) {
  if (rings.length === 0) return null;
  return (
    <table class="numbers rings">
      <caption>{say("rings")}</caption>
      <thead>
        <tr>
          <th scope="col">{say("angle")}</th>
          <th scope="col">L*</th>
          <th scope="col">C*</th>
          <th scope="col">{say("hue")}</th>
        </tr>
      </thead>
      <tbody>
        {rings.map(({ view_deg, colour }) => (
          <tr key={view_deg}>
            <th scope="row">{view_deg.toFixed(0)}°</th>
            <td>{colour === null ? "–" : shown(colour.lightness, "")}</td>
            <td>{colour === null ? "–" : shown(colour.chroma, "")}</td>
            <td>{colour?.hue_deg == null ? "–" : shown(colour.hue_deg, "°")}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Refused({ measures }: { measures: Measures }) {
  if (measures.refused.length === 0) return null;
  return (
    <dl class="refused">
      {measures.refused.map(({ quantity, reason }) => (
        <div key={quantity}>
          <dt>
            {say(REFUSED[quantity] ?? "refused")}
            <span class="trade">{say("refused")}</span>
          </dt>
          <dd>
            <Said {...refusalSays(reason)} />
          </dd>
        </div>
      ))}
    </dl>
  );
}
