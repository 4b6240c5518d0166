/** CIEDE2000 between A and B: a map in false colours, and what it comes to over the pearl. */

import { useEffect, useRef, useState } from "preact/hooks";
import type { Difference as Found } from "nacreous-wasm";
import { ask } from "../light/desk";
import { SPACE } from "../state/engines";
import { type Finished, finished } from "../state/finished";
import { short } from "../state/scale";
import { fileWord } from "../words/files";
import { refusalSays } from "../words/refusals";
import { Said } from "./Said";
import { FALSE_COLOURS, falseColours } from "./falseColours";

/** Differences from which the map's colour stays the same. */
const MOST = 10;

export function Difference() {
  const [a, b] = [finished.a.value, finished.b.value];
  const [found, setFound] = useState<Found | null>(null);
  const [failed, setFailed] = useState("");
  useEffect(() => {
    let wanted = true;
    setFound(null);
    setFailed("");
    if (a === null || b === null || a.size !== b.size) return;
    between(a, b).then(
      (made) => wanted && setFound(made),
      (error: unknown) => wanted && setFailed((error as Error).message),
    );
    return () => {
      wanted = false;
    };
  }, [a, b]);
  return (
    <section class="difference">
      <h2>{fileWord("difference")}</h2>
      <p class="says">{fileWord("differenceAbout")}</p>
      {failed !== "" && (
        <p role="alert">
          <Said {...refusalSays(failed)} />
        </p>
      )}
      {found === null || a === null ? (
        <p class="says">{fileWord("differenceWaits")}</p>
      ) : (
        <Shown found={found} size={a.size} />
      )}
    </section>
  );
}

/** Over the pixels that are the pearl's in both. */
function between(a: Finished, b: Finished): Promise<Found> {
  const covered = a.covered.map((one, i) => one & (b.covered[i] ?? 0));
  return ask("difference", { first: a.codes, second: b.codes, covered, space: SPACE });
}

function Shown({ found, size }: { found: Found; size: number }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const codes = falseColours(found.map, MOST);
    canvas.current?.getContext("2d")?.putImageData(new ImageData(codes, size, size), 0, 0);
  }, [found, size]);
  const number = (word: "mean" | "percentile" | "largest", value: number) => (
    <div>
      <dt>{fileWord(word)}</dt>
      <dd data-measure={word}>{short(Number(value.toFixed(2)))}</dd>
    </div>
  );
  return (
    <>
      {found.pixels === 0 ? (
        <p class="says">{fileWord("noPearl")}</p>
      ) : (
        <>
          <dl class="measures">
            {number("mean", found.mean)}
            {number("percentile", found.percentile95)}
            {number("largest", found.largest)}
          </dl>
          <p class="says">{fileWord("overPearl", { n: found.pixels })}</p>
        </>
      )}
      <canvas
        ref={canvas}
        class="map"
        width={size}
        height={size}
        role="img"
        aria-label={fileWord("differenceMap", { most: MOST })}
      />
      <Legend largest={found.largest} />
    </>
  );
}

function Legend({ largest }: { largest: number }) {
  const stops = FALSE_COLOURS.map((rgb) => `rgb(${rgb.join(" ")})`);
  return (
    <div class="legend">
      <div style={{ backgroundImage: `linear-gradient(to right, ${stops.join(", ")})` }} />
      <span>0</span>
      <span>{MOST / 2}</span>
      <span>{fileWord("andMore", { most: MOST })}</span>
      {largest > MOST && (
        <p>{fileWord("coloursEnd", { most: MOST, largest: short(Number(largest.toFixed(2))) })}</p>
      )}
    </div>
  );
}
