/** A picture file that was opened: its layers, the values under a probe, and what it was made from. */

import { useEffect, useRef, useState } from "preact/hooks";
import type { Plane } from "nacreous-files";
import { ask } from "../light/desk";
import type { Codes } from "../light/messages";
import { SPACE } from "../state/engines";
import { type Opened as Found, opened } from "../state/opened";
import { takeGrain, takeOpened } from "../state/opening";
import { refused } from "../state/store";
import { fileSays } from "../words/complaints";
import { fileWord, layerName } from "../words/files";
import { Probe, type Place } from "./Probe";
import { Said } from "./Said";

const MOST_LINES = 6;

export function Opened() {
  const found = opened.value;
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (found !== null && dialog.current?.open === false) dialog.current.showModal();
  }, [found]);
  if (found === null) return null;
  const close = () => (opened.value = null);
  return (
    <dialog ref={dialog} class="opened" aria-labelledby="opened-name" onClose={close}>
      <h2 id="opened-name">{found.name}</h2>
      {found.layers !== null && <Layers key={found.name} found={found} />}
      {found.specs !== null && (
        <p>
          {fileWord("holdsRecipe", {
            pearl: found.specs.pearl.name,
            scene: found.specs.scene.name,
          })}
        </p>
      )}
      {found.complaints.length > 0 && (
        <div class="message wrong" role="alert">
          <strong>{fileWord("noRecipe")}</strong>
          <ul>
            {found.complaints.slice(0, MOST_LINES).map((one) => (
              <li key={one.text}>
                <Said {...fileSays(one)} />
              </li>
            ))}
          </ul>
        </div>
      )}
      <div class="row">
        {found.specs !== null && (
          <button type="button" class="main" onClick={takeOpened}>
            {fileWord("takeRecipe")}
          </button>
        )}
        {found.photograph !== null && <TakeGrain found={found} />}
        <button type="button" onClick={close}>
          {fileWord("close")}
        </button>
      </div>
    </dialog>
  );
}

function TakeGrain({ found: { photograph, name } }: { found: Found }) {
  const go = async () => {
    opened.value = null;
    if (photograph === null) return;
    const complaints = await takeGrain(photograph, name);
    if (complaints.length > 0) refused.value = { from: "file", complaints };
  };
  return (
    <button type="button" onClick={() => void go()}>
      {fileWord("takeGrain")}
    </button>
  );
}

function Layers({ found }: { found: Found }) {
  const planes = found.layers?.planes ?? [];
  const [name, setName] = useState(planes[0]?.name ?? "");
  const [place, setPlace] = useState<Place | null>(null);
  const plane = planes.find((one) => one.name === name);
  const { width, height } = found.layers ?? { width: 1, height: 1 };
  const { canvas, codes } = usePlane(plane, width, height);
  return (
    <>
      <label>
        {fileWord("layer")}{" "}
        <select value={name} onChange={(event) => setName(event.currentTarget.value)}>
          {planes.map((one) => (
            <option key={one.name} value={one.name}>
              {layerName(one.name)}
            </option>
          ))}
        </select>
      </label>
      <Probe canvas={canvas} size={{ width, height }} place={place} move={setPlace} />
      <Values plane={plane} codes={codes} width={width} place={place} />
    </>
  );
}

/** Draws a layer; gives its codes. */
function usePlane(plane: Plane | undefined, width: number, height: number) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [codes, setCodes] = useState<Codes | null>(null);
  useEffect(() => {
    let wanted = true;
    setCodes(null);
    if (plane === undefined) return;
    const draw = (made: Codes) => {
      if (!wanted) return;
      setCodes(made);
      const context = canvas.current?.getContext("2d", { colorSpace: SPACE });
      context?.putImageData(new ImageData(made, width, height, { colorSpace: SPACE }), 0, 0);
    };
    ask("codes", { rgb: shownLight(plane), space: SPACE }).then(draw, (error: unknown) => {
      const text = (error as Error).message;
      refused.value = { from: "file", complaints: [{ path: "", text }] };
      opened.value = null;
    });
    return () => {
      wanted = false;
    };
  }, [plane, width, height]);
  return { canvas, codes };
}

/** Deviations of the grain are shown around this grey. */
const GREY = 0.2;

/** A layer as linear light: one number as grey, deviations around a middle grey. */
function shownLight({ name, channels, samples }: Plane): Float32Array<ArrayBuffer> {
  const step = channels.length;
  const base = name === "texture" ? GREY : 0;
  const light = new Float32Array((samples.length / step) * 3);
  for (let i = 0; i < light.length; i += 1) {
    const channel = step === 1 ? 0 : i % 3;
    light[i] = base + (samples[Math.floor(i / 3) * step + channel] ?? 0);
  }
  return light;
}

interface ValuesGiven {
  readonly plane: Plane | undefined;
  readonly codes: Codes | null;
  readonly width: number;
  readonly place: Place | null;
}

/** Linear values and codes of the pixel at the probe. */
function Values({ plane, codes, width, place }: ValuesGiven) {
  if (plane === undefined || place === null) {
    return <p class="says probe-values">{fileWord("probeHint")}</p>;
  }
  const at = place.row * width + place.column;
  const step = plane.channels.length;
  const linear = [...plane.samples.subarray(at * step, (at + 1) * step)];
  return (
    <dl class="probe-values" aria-live="polite">
      <div>
        <dt>{fileWord("column")}</dt>
        <dd>{place.column}</dd>
      </div>
      <div>
        <dt>{fileWord("row")}</dt>
        <dd>{place.row}</dd>
      </div>
      <div>
        <dt>
          {fileWord("linear")} {plane.channels.join(" ")}
        </dt>
        <dd>{linear.map((value) => value.toPrecision(5)).join("  ")}</dd>
      </div>
      {codes !== null && (
        <div>
          <dt>{fileWord("code")} R G B</dt>
          <dd>{[...codes.subarray(at * 4, at * 4 + 3)].join("  ")}</dd>
        </div>
      )}
    </dl>
  );
}
