/** Where the pictures are: one, two side by side, or two parted by a line. */

import { useEffect, useRef } from "preact/hooks";
import { type Signal, useSignal } from "@preact/signals";
import { isIdle, mainPool, otherPool, SAMPLES, SPACE } from "../state/engines";
import { saveExr, savePng } from "../state/files";
import { active, board, moving, resolved, specs } from "../state/store";
import { SIZES, size, wipe, wiping } from "../state/view";
import { t } from "../words/speech";
import { beginComparing } from "./Compare";
import { Dome } from "./Dome";
import { Messages } from "./Messages";
import type { Making } from "./Picture";
import { Stage } from "./Stage";

/** Whether fingers are what the page is used with; on a page as narrow as a phone they are. */
const IS_TOUCHED = matchMedia("(pointer: coarse), (hover: none), (width < 48rem)").matches;

const NOTHING: Making = { stage: null, share: 0, failed: "" };

/** The canvas whose picture is saved. */
export const activeCanvas: { current: HTMLCanvasElement | null } = { current: null };

export function Bench() {
  const canvases = { a: useRef<HTMLCanvasElement>(null), b: useRef<HTMLCanvasElement>(null) };
  const makings = { a: useSignal(NOTHING), b: useSignal(NOTHING) };
  const two = board.value.b !== null;
  const isDone = (one: Signal<Making>) => one.value.stage === "refined" || one.value.failed !== "";
  const idle = !moving.value && isDone(makings.a) && (!two || isDone(makings.b));
  useEffect(() => {
    isIdle.value = idle;
  }, [idle]);
  useResolved(idle);
  const bench = useHeight("--bench");
  activeCanvas.current = canvases[two ? active.value : "a"].current;
  return (
    <div class="bench" ref={bench}>
      <Messages />
      <div class={two ? (wiping.value ? "pictures wiping" : "pictures two") : "pictures"}>
        <div class={two && active.value === "a" ? "side on" : "side"}>
          <Stage
            which="a"
            pool={mainPool}
            size={size.value}
            canvas={canvases.a}
            making={makings.a}
          />
          {two && <span class="letter">{t("sideA")}</span>}
        </div>
        {two && (
          <div
            class={active.value === "b" ? "side on" : "side"}
            style={wiping.value ? { clipPath: `inset(0 0 0 ${wipe.value * 100}%)` } : {}}
          >
            <Stage
              which="b"
              pool={otherPool}
              size={size.value}
              canvas={canvases.b}
              making={makings.b}
            />
            <span class="letter">{t("sideB")}</span>
          </div>
        )}
      </div>
      {two && wiping.value && (
        <input
          class="wipe"
          type="range"
          min={0}
          max={1000}
          aria-label={t("wipeAt")}
          value={wipe.value * 1000}
          onInput={(event) => (wipe.value = Number(event.currentTarget.value) / 1000)}
        />
      )}
      <div class="under">
        <Dome />
        <div class="facts">
          <p class="hint">{t(IS_TOUCHED ? "hintTouch" : "hint")}</p>
          <div class="row">
            <label>
              <span class="sr-only">{t("pictureSize")}</span>
              <select
                value={String(size.value)}
                onChange={(event) => (size.value = Number(event.currentTarget.value))}
              >
                {SIZES.map((one) => (
                  <option key={one} value={String(one)}>
                    {t("pixels", { n: one })}
                  </option>
                ))}
              </select>
            </label>
            {!two && (
              <button
                type="button"
                class="beside"
                title={t("compareStart")}
                onClick={beginComparing}
              >
                {t("tabCompare")}
              </button>
            )}
            {SPACE === "display-p3" && <span class="badge">{t("wide")}</span>}
          </div>
          <p class="sr-only" role="status">
            {idle ? t("refined") : ""}
          </p>
        </div>
      </div>
    </div>
  );
}

/** Keeps the height of an element as a property of the page, for what stays below it. */
function useHeight(property: string) {
  const element = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (element.current === null) return;
    const style = document.documentElement.style;
    const watch = new ResizeObserver(([entry]) => {
      const height = entry?.borderBoxSize[0]?.blockSize ?? 0;
      style.setProperty(property, `${height}px`);
    });
    watch.observe(element.current);
    return () => watch.disconnect();
  }, []);
  return element;
}

/** The open keys' values, asked for when the picture is finished. */
function useResolved(idle: boolean): void {
  const { pearl } = specs.value;
  useEffect(() => {
    if (!idle) return;
    let wanted = true;
    void mainPool()
      .resolve(JSON.stringify(pearl, plain))
      .then((keys) => {
        if (wanted) resolved.value = keys;
      });
    return () => {
      wanted = false;
    };
  }, [idle, pearl]);
}

/** Seeds may be larger than JSON's numbers; what keys come to does not hang on them. */
function plain(_key: string, value: unknown): unknown {
  return typeof value === "bigint" ? 1 : value;
}

export function saveActivePng(): void {
  const canvas = activeCanvas.current;
  if (canvas === null) return;
  void savePng(canvas, { size: canvas.width, samples: SAMPLES, space: SPACE });
}

export function saveActiveExr(): void {
  void saveExr(size.value, SAMPLES);
}
