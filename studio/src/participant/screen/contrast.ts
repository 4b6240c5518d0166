/** Rings with a gap (Landolt's), fainter and fainter, on the grey that the pictures are shown on. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import { mayHaveKeys } from "../keyboard";
import { sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";
import { chance, oneOf } from "./chance";
import type { Share } from "./content";
import { listen, Series } from "./series";

/** How much darker than the grey around it a ring is, as a share of its luminance (Weber). */
export const CONTRASTS = [0.5, 0.25, 0.25, 0.12, 0.12, 0.06, 0.06, 0.04, 0.04, 0.04] as const;

const SIDE_PX = 220;
/** Landolt's proportions: stroke and gap are a fifth of the ring. */
const STROKE = 1 / 5;

const GAPS = ["up", "right", "down", "left"] as const;
type Gap = (typeof GAPS)[number];
const KEYS: Record<string, Gap> = {
  ArrowUp: "up",
  ArrowRight: "right",
  ArrowDown: "down",
  ArrowLeft: "left",
};

/** The grey code of a ring on `grey`, on a screen that is the power `gamma`; at least one off. */
export function codeOf(contrast: number, gamma: number, grey: number): number {
  const code = grey * (1 - contrast) ** (1 / gamma);
  return Math.min(grey - 1, Math.round(code));
}

export function contrastPage(
  words: Words,
  step: string,
  seed: number,
  gamma: number,
  grey: number,
): Page<Share> {
  const next = chance(seed);
  const gaps = CONTRASTS.map(() => oneOf(GAPS, next));
  return {
    name: "contrast",
    draw(into, done) {
      const canvas = element("canvas", { class: "ring", role: "img" });
      canvas.setAttribute("aria-label", words.contrast_question);
      const count = element("p", { class: "now", role: "status" });
      const take = (gap: Gap) => rings.take(gap);
      const choices = GAPS.map((gap) => button(words[gap], () => take(gap), { class: gap }));
      const body = [
        element("p", {}, mayHaveKeys() ? words.contrast : words.contrast_touch),
        element("p", { class: "soft" }, words.no_medical),
        element("div", { class: "rings" }, canvas, ...choices),
        count,
      ];
      sheet(into, words.contrast_title, body, [], [step]);
      const show = (at: number) => {
        draw(canvas, gaps[at] ?? "up", codeOf(CONTRASTS[at] ?? 1, gamma, grey), grey);
        count.textContent = fill(words.contrast_of, { n: at + 1, all: gaps.length });
      };
      const rings = new Series(gaps, show, done);
      return listen((key) => KEYS[key], take);
    },
    play(into) {
      for (const gap of gaps) into.querySelector<HTMLElement>(`.rings .${gap}`)?.click();
    },
  };
}

function draw(canvas: HTMLCanvasElement, gap: Gap, code: number, grey: number): void {
  const side = Math.round(SIDE_PX * devicePixelRatio);
  canvas.width = canvas.height = side;
  const pen = canvas.getContext("2d");
  if (pen === null) return;
  pen.fillStyle = `rgb(${grey} ${grey} ${grey})`;
  pen.fillRect(0, 0, side, side);
  const outer = side * 0.42;
  const stroke = 2 * outer * STROKE;
  pen.translate(side / 2, side / 2);
  pen.rotate(((GAPS.indexOf(gap) - 1) * Math.PI) / 2);
  pen.strokeStyle = `rgb(${code} ${code} ${code})`;
  pen.lineWidth = stroke;
  pen.beginPath();
  pen.arc(0, 0, outer - stroke / 2, 0, 2 * Math.PI);
  pen.stroke();
  pen.fillRect(0, -stroke / 2, outer + 1, stroke);
}
