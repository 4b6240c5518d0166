/** The screen check, from the window to the eyes, as the study's rules want it. */

import { fill } from "../../shared/language";
import type { Picture, ScreenRules, Study } from "../api";
import { reading } from "../sheet";
import type { Stage } from "../stage";
import type { Words } from "../words/words";
import { cardPage } from "./card";
import { colourPage } from "./colour";
import { told } from "./content";
import type { ScreenContent } from "./content";
import { contrastPage } from "./contrast";
import { blindSpotPage, median, typedPage, wideEnough } from "./distance";
import type { Distance } from "./distance";
import { canFill, fullPage } from "./full";
import { darkPage, gammaPage } from "./levels";
import { largeEnough, windowPage } from "./window";

/** Of screens that nobody measured. */
const USUAL_GAMMA = 2.2;

type Step = "full" | "card" | "distance" | "gamma" | "dark" | "contrast" | "colour";

/** The steps that a study asks for and this browser can take. */
export function stepsOf(
  rules: Pick<ScreenRules, "full_screen" | "card" | "distance" | "levels" | "vision">,
  fills: boolean,
): Step[] {
  const steps: Step[] = [];
  if (rules.full_screen && fills) steps.push("full");
  if (rules.card) steps.push("card");
  if (rules.distance) steps.push("distance");
  if (rules.levels) steps.push("gamma", "dark");
  return [...steps, ...rules.vision];
}

export class ScreenCheck {
  private readonly steps: Step[];
  private readonly rules: ScreenRules;
  private readonly grey: number;

  constructor(
    private readonly stage: Stage,
    private readonly words: Words,
    study: Pick<Study, "screen" | "background_code">,
    private readonly seed: number,
    private readonly pictures: readonly Picture[],
  ) {
    this.rules = study.screen;
    this.grey = study.background_code;
    this.steps = stepsOf(this.rules, canFill());
  }

  /** Go through all steps. */
  async run(): Promise<ScreenContent> {
    const { stage, words } = this;
    if (this.steps.length > 0) {
      const text = [words.screen_intro, words.screen_advice];
      await stage.show(reading("screen", words.screen_title, text, [["go", words.begin]]));
    }
    if (this.asks("full")) await stage.show(fullPage(words, this.title("full")));
    if (!largeEnough(this.rules)) await stage.show(windowPage(words, this.rules));
    const px_per_mm = this.asks("card")
      ? await stage.show(cardPage(words, this.title("card")))
      : null;
    const distance = this.asks("distance") ? await this.distance(px_per_mm) : null;
    const levels = await this.levels();
    const vision = await this.vision(levels.gamma ?? USUAL_GAMMA);
    const widths = this.pictures.map(({ width_mm }) => width_mm);
    return {
      ...told(), // at the end: the window as the pictures will be shown in it
      card: px_per_mm === null ? null : { px_per_mm },
      picture_width_mm: px_per_mm === null ? null : Math.max(...widths),
      distance_mm: distance?.distance_mm ?? null,
      distance_by: distance?.by ?? "none",
      distance_tries_mm: distance?.tries_mm ?? [],
      ...levels,
      vision,
      simulated: stage.simulation !== null,
    };
  }

  private async distance(px_per_mm: number | null): Promise<Distance> {
    const title = this.title("distance");
    if (px_per_mm !== null && wideEnough(innerWidth, px_per_mm)) {
      const tries_mm = await this.stage.show(
        blindSpotPage(this.words, title, px_per_mm, this.rules),
      );
      if (tries_mm !== null) return { distance_mm: median(tries_mm), by: "blind-spot", tries_mm };
    }
    const typed_mm = await this.stage.show(typedPage(this.words, title, this.rules));
    return { distance_mm: typed_mm, by: typed_mm === null ? "none" : "typed", tries_mm: [] };
  }

  private async levels(): Promise<Pick<ScreenContent, "gamma" | "darkest_step">> {
    if (!this.asks("gamma")) return { gamma: null, darkest_step: null };
    const gamma = await this.stage.show(gammaPage(this.words, this.title("gamma")));
    const darkest_step = await this.stage.show(darkPage(this.words, this.title("dark")));
    return { gamma, darkest_step };
  }

  private async vision(gamma: number): Promise<ScreenContent["vision"]> {
    const { stage, words, seed } = this;
    const found: ScreenContent["vision"] = {};
    if (this.asks("contrast")) {
      const title = this.title("contrast");
      found.contrast = await stage.show(contrastPage(words, title, seed, gamma, this.grey));
    }
    if (this.asks("colour")) {
      found.colour = await stage.show(colourPage(words, this.title("colour"), seed));
    }
    return found;
  }

  private asks(step: Step): boolean {
    return this.steps.includes(step);
  }

  private title(step: Step): string {
    const places = { n: this.steps.indexOf(step) + 1, all: this.steps.length };
    return fill(this.words.screen_step, places);
  }
}
