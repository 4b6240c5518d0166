/** The pearl: drag turns the camera, the wheel zooms. */

import { useRef } from "preact/hooks";
import type { Signal } from "@preact/signals";
import type { Pool } from "../light/pool";
import type { Specs } from "../specs/spec";
import { turned, zoomed } from "../state/camera";
import { type Fault, faultsIn } from "../state/faults";
import { finished } from "../state/finished";
import { hasKnob } from "../state/groups";
import { declared } from "../state/path";
import { type Which, active, board, editScene, moving, touch } from "../state/store";
import { tab } from "../state/view";
import { knobSays } from "../words/complaints";
import { refusalSays } from "../words/refusals";
import { nameOf, t } from "../words/speech";
import { Probe } from "./instruments/Probe";
import { type Making, usePicture } from "./Picture";
import { Said } from "./Said";

/** Degrees of a press of an arrow key, over degrees of a dragged pixel. */
const KEY_PX = 14;
const FINE_PX = 3;
/** So many reasons are told over a picture. */
const MOST_SAID = 2;

interface Given {
  readonly which: Which;
  readonly pool: () => Pool;
  readonly size: number;
  readonly canvas: { current: HTMLCanvasElement | null };
  readonly making: Signal<Making>;
}

export function Stage({ which, pool, size, canvas, making }: Given) {
  const side = (which === "b" ? board.value.b : null) ?? board.value.a;
  usePicture({
    specs: side.specs,
    moving: moving.value,
    size,
    pool,
    canvas,
    tell: (now) => (making.value = now),
    finish: (whole) => (finished[which].value = whole),
  });
  const hand = useHand(which);
  const isActive = board.value.b === null || active.value === which;
  return (
    <div class="stage">
      <canvas
        ref={canvas}
        class="pearl"
        width={2}
        height={2}
        tabIndex={0}
        role="img"
        aria-label={t("pearlPicture")}
        data-stage={making.value.stage ?? "none"}
        {...hand}
      />
      {tab.value === "instruments" && isActive && <Probe />}
      <Hairline making={making.value} />
      {making.value.stage === null && making.value.failed === "" && (
        <p class="waiting">{t("working")}</p>
      )}
      {making.value.failed !== "" && (
        <Failed text={making.value.failed} specs={side.specs} isActive={isActive} />
      )}
    </div>
  );
}

interface FailedGiven {
  readonly text: string;
  readonly specs: Specs;
  /** Whether the knobs turn this side. */
  readonly isActive: boolean;
}

/** Why there is no picture; what a knob on the page says already is not said again. */
function Failed({ text, specs, isActive }: FailedGiven) {
  const faults = faultsIn(specs);
  const isAtKnob = ({ kind, path }: Fault) =>
    isActive && tab.value === kind && hasKnob(kind, specs[kind], path);
  const others = faults.filter((one) => !isAtKnob(one)).slice(0, MOST_SAID);
  const said = faults.length === 0 ? [refusalSays(text)] : others.map(knobSays);
  const names = faults.map((one) => nameOf(declared(one.path)));
  return (
    <div class="failed" role="alert">
      <strong>{t("failed")}</strong>{" "}
      {said.length === 0 && t("failedSee", { names: names.join(", ") })}
      {said.map((one) => (
        <p key={one.text}>
          <Said {...one} />
        </p>
      ))}
    </div>
  );
}

function Hairline({ making }: { making: Making }) {
  const isOn = making.stage !== "refined" && making.failed === "";
  return (
    <div class={isOn ? "hairline" : "hairline off"} aria-hidden="true">
      <div style={{ transform: `scaleX(${isOn ? making.share : 1})` }} />
    </div>
  );
}

/** What pointer, wheel and keys do to a side. */
function useHand(which: Which) {
  const fingers = useRef(new Map<number, { x: number; y: number }>());
  const apart = useRef(0);
  const specs = () => ((which === "b" ? board.value.b : null) ?? board.value.a).specs;
  const mine = () => {
    if (board.value.b !== null) active.value = which;
  };
  const turn = (right: number, down: number) =>
    editScene("camera", turned(specs().scene, right, down));
  const zoom = (factor: number) => editScene("zoom", zoomed(specs(), factor));
  const back = () => {
    const side = (which === "b" ? board.value.b : null) ?? board.value.a;
    editScene("back", { camera: side.origin.scene.camera });
  };
  return {
    onPointerDown(event: PointerEvent) {
      mine();
      const canvas = event.currentTarget as HTMLElement;
      canvas.setPointerCapture(event.pointerId);
      fingers.current.set(event.pointerId, { x: event.clientX, y: event.clientY });
      apart.current = 0;
    },
    onPointerMove(event: PointerEvent) {
      const before = fingers.current.get(event.pointerId);
      if (before === undefined) return;
      fingers.current.set(event.pointerId, { x: event.clientX, y: event.clientY });
      const [one, two] = [...fingers.current.values()];
      if (one !== undefined && two !== undefined) {
        const now = Math.hypot(one.x - two.x, one.y - two.y);
        if (apart.current > 0 && now > 0) zoom(apart.current / now);
        apart.current = now;
      } else {
        const [right, down] = [event.clientX - before.x, event.clientY - before.y];
        if (right !== 0 || down !== 0) turn(right, down);
      }
    },
    onPointerUp: (event: PointerEvent) => fingers.current.delete(event.pointerId),
    onPointerCancel: (event: PointerEvent) => fingers.current.delete(event.pointerId),
    onWheel(event: WheelEvent) {
      event.preventDefault();
      mine();
      zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.002));
    },
    onDblClick() {
      mine();
      back();
    },
    onKeyDown(event: KeyboardEvent) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const by = event.shiftKey ? FINE_PX : KEY_PX;
      const acts: Record<string, () => void> = {
        ArrowLeft: () => turn(by, 0),
        ArrowRight: () => turn(-by, 0),
        ArrowUp: () => turn(0, by),
        ArrowDown: () => turn(0, -by),
        "+": () => zoom(0.9),
        "=": () => zoom(0.9),
        "-": () => zoom(1 / 0.9),
        "0": back,
      };
      const act = acts[event.key];
      if (act === undefined) return;
      event.preventDefault();
      mine();
      touch();
      act();
    },
  };
}
