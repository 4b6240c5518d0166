/** The ring on the picture: where the instruments look. */

import { useEffect, useRef } from "preact/hooks";
import { fixed, found, hovered, isDrawn, isFresh, place, reading } from "../../state/instruments";
import { size } from "../../state/view";
import { say } from "../../words/instruments";
import { copySpectra, degrees } from "./Point";

/** A press of an arrow key moves the ring by so much of the width. */
const STEP = 0.02;
const FINE = 0.004;
/** A hand that moved farther between press and release has turned the camera. */
const STILL_PX = 4;

export function Probe() {
  const here = useRef<HTMLButtonElement>(null);
  usePointing(here);
  const { x, y } = place.value;
  const angle = reading.value == null ? "" : degrees(reading.value.angleRad);
  return (
    <>
      {isDrawn.value && isFresh.value && <Drawn />}
      <button
        ref={here}
        type="button"
        class="probe"
        style={{ left: `${100 * x}%`, top: `${100 * y}%` }}
        aria-label={say("probe", {
          x: Math.round(100 * x),
          y: Math.round(100 * y),
          angle: angle === "" ? "" : say("probeAngle", { n: angle }),
        })}
        onKeyDown={(event) => {
          const by = event.shiftKey ? FINE : STEP;
          const steps: Record<string, [number, number]> = {
            ArrowLeft: [-by, 0],
            ArrowRight: [by, 0],
            ArrowUp: [0, -by],
            ArrowDown: [0, by],
          };
          const step = steps[event.key];
          if (step === undefined) return;
          event.preventDefault();
          hovered.value = null;
          fixed.value = { x: within(fixed.value.x + step[0]), y: within(fixed.value.y + step[1]) };
        }}
        onClick={copySpectra}
      />
    </>
  );
}

/** What was found in the picture: outline, half level of the lamp's image, spots. */
function Drawn() {
  const measures = found.value?.measures;
  if (measures == null) return null;
  const { place, lamp, blemishes } = measures;
  const line = (places: readonly (readonly [number, number])[]) =>
    places.length === 0 ? "" : `M${places.map((one) => one.join(" ")).join("L")}Z`;
  return (
    <svg class="drawn" viewBox={`0 0 ${size.value} ${size.value}`} aria-hidden="true">
      <path d={line(place.line)} />
      <path d={line(lamp?.line ?? [])} class="lamp" />
      {blemishes?.spots.map(({ x_px, y_px, radius_px }, i) => (
        <circle key={i} cx={x_px} cy={y_px} r={radius_px} />
      ))}
    </svg>
  );
}

const within = (share: number) => Math.min(0.999, Math.max(0, share));

/** Follows the pointer over the picture; a press without a drag stays there. */
function usePointing(here: { current: HTMLElement | null }): void {
  useEffect(() => {
    const canvas = here.current?.parentElement?.querySelector("canvas");
    if (canvas === null || canvas === undefined) return;
    let pressed: { x: number; y: number } | null = null;
    const placeOf = (event: PointerEvent) => {
      const box = canvas.getBoundingClientRect();
      return {
        x: within((event.clientX - box.left) / box.width),
        y: within((event.clientY - box.top) / box.height),
      };
    };
    const move = (event: PointerEvent) => {
      if (event.pointerType === "mouse" && event.buttons === 0) hovered.value = placeOf(event);
    };
    const down = (event: PointerEvent) => (pressed = { x: event.clientX, y: event.clientY });
    const up = (event: PointerEvent) => {
      const far = pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y);
      if (far !== null && far < STILL_PX) fixed.value = placeOf(event);
      pressed = null;
    };
    const leave = () => (hovered.value = null);
    const listeners = { pointermove: move, pointerdown: down, pointerup: up, pointerleave: leave };
    const all = Object.entries(listeners) as [keyof typeof listeners, (e: PointerEvent) => void][];
    for (const [name, listen] of all) canvas.addEventListener(name, listen);
    return () => {
      for (const [name, listen] of all) canvas.removeEventListener(name, listen);
      hovered.value = null;
    };
  }, []);
}
