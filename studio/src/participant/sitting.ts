/** A whole sitting, from the first page to the last. */

import { Problem } from "../shared/http";
import { fill, preferred, said } from "../shared/language";
import type { Language } from "../shared/language";
import { canBeKept, parametersOf, placesOf } from "./address";
import type { Places } from "./address";
import { Answers } from "./answers";
import { Api, study as studyOf } from "./api";
import type { SittingTold, Study, Trial } from "./api";
import { blocksOf, placeOf, Presenter } from "./block";
import { barred, Entering, sittingOf } from "./entering";
import { linked } from "./storage/kept";
import type { Kept } from "./storage/kept";
import type { Notice } from "./notice";
import { adaptPage } from "./pages/adapt";
import {
  breakPage,
  instructionsPage,
  resumedPage,
  stopPage,
  trainingOverPage,
} from "./pages/between";
import { Ended } from "./pages/ends";
import { loadingPage, sendingPage } from "./pages/waiting";
import { Pictures } from "./pictures";
import { reach } from "./reach";
import { ScreenCheck } from "./screen/check";
import type { ScreenContent } from "./screen/content";
import { fillScreen } from "./screen/full";
import { reading } from "./sheet";
import type { Stage } from "./stage";
import { taskOf } from "./task/tasks";
import { WORDS } from "./words/words";
import type { Words } from "./words/words";

export class Sitting {
  /** Of the page's address, those that the study keeps. */
  readonly parameters: Record<string, string>;
  private language: Language = "en";
  private readonly places: Places;

  constructor(
    private readonly stage: Stage,
    private readonly notice: Notice,
    private readonly kept: Kept,
    private readonly study: Study,
  ) {
    this.parameters = parametersOf(location.search, study.parameters);
    this.places = placesOf(study.name, this.parameters);
    this.speak(preferred(study.languages, navigator.languages));
  }

  get words(): Words {
    return WORDS[this.language];
  }

  /** Go through all of it; throws `Ended` or `Problem` where it ends before its end. */
  async run(): Promise<void> {
    const own = linked(location.hash) ?? (await this.kept.token(this.places[0]));
    let api = new Api(own ?? this.study.token);
    const found = own === null ? null : await this.reach(() => sittingOf(api));
    const left = found === null && linked(location.hash) === null; // by another study, perhaps
    if (left && this.study.registration === "open") api = new Api(this.study.token);
    void this.sendLeftBehind(api.token);
    let sitting = await this.entered(api, found, own !== null);
    if (sitting.finished) throw new Ended("thanks", sitting.ending);
    const screen = await this.screened(api, sitting);
    if (sitting.trials.length === 0) sitting = await this.reach(() => api.sitting());
    await this.answered(api, sitting, screen);
    sitting = await this.reach(() => api.sitting());
    throw new Ended("thanks", sitting.ending);
  }

  /** Forget whose sitting it is, so that another person can begin. */
  forget(): Promise<void> {
    return this.kept.forgetToken(this.places);
  }

  /** Send what others, who left this browser without a network, have answered. */
  private async sendLeftBehind(own: string): Promise<void> {
    for (const token of await this.kept.unfinished()) {
      if (token === own) continue;
      const api = new Api(token);
      const sitting = await sittingOf(api).catch(() => null);
      if (sitting === null) continue;
      const log = this.kept.log(sitting.sitting);
      await new Answers(api, log, () => undefined).resume(sitting.answered);
    }
  }

  /** A request, made until the server answers, with a notice as long as it does not. */
  readonly reach = <T>(request: () => Promise<T>): Promise<T> => reach(request, this.connected);

  private readonly connected = (yes: boolean): void => {
    if (yes) this.notice.hide();
    else this.notice.show(this.words.offline);
  };

  private speak(language: Language): void {
    this.language = language;
    document.documentElement.lang = language;
    document.title = this.words.consent_title;
  }

  private async entered(api: Api, found: SittingTold | null, own: boolean): Promise<SittingTold> {
    const speak = (language: Language) => this.speak(language);
    const keep = () => this.kept.keepToken(this.places, api.token);
    const { stage, study, parameters } = this;
    const entering = new Entering(stage, study, api, this.reach, speak, parameters);
    if (found === null) {
      const bar = barred(this.study, own);
      if (bar !== null) throw new Ended(bar);
      if (!canBeKept(parameters)) throw new Ended("unknown"); // before anything is asked
      return entering.enter(keep).catch((reason: unknown) => this.barredNow(reason));
    }
    await keep();
    this.speak(found.language);
    return found.consented ? found : entering.again(found);
  }

  /** Why somebody was not let in: the study was paused meanwhile, or the link is no good. */
  private async barredNow(reason: unknown): Promise<never> {
    const bad = Object.keys(this.parameters).length > 0 ? ["input"] : []; // cut off, say
    const kinds = ["not-allowed", "token", ...bad];
    if (!(reason instanceof Problem && kinds.includes(reason.kind))) throw reason;
    await this.forget();
    const { state } = await this.reach(studyOf);
    throw new Ended(state === "open" ? "unknown" : state);
  }

  /** Notes and the screen check, unless this browser on this screen went through them. */
  private async screened(api: Api, sitting: SittingTold): Promise<ScreenContent> {
    const { words, stage } = this;
    const kept = await this.kept.screen(api.token);
    const same = kept?.screen.width_px === screen.width && kept.screen.height_px === screen.height;
    if (kept !== null && same && sitting.screened && !sitting.refused) return kept;
    const notes = sitting.groups_notes.map((note) => said(note, this.language));
    if (notes.length > 0 && !sitting.screened) {
      await stage.show(reading("notes", words.notes_title, notes, [["go", words.go_on]]));
    }
    const pictures = Object.values(sitting.pictures);
    const check = new ScreenCheck(stage, words, this.study, sitting.number, pictures);
    const content = await check.run();
    const found = await this.reach(() => api.screen(content));
    await this.kept.keepScreen(api.token, content).catch(() => undefined);
    if (found.refused) throw new Ended("refused");
    return content;
  }

  /** All trials that are left, their pages in between, and the end. */
  private async answered(api: Api, sitting: SittingTold, content: ScreenContent): Promise<void> {
    const answers = new Answers(api, this.kept.log(sitting.sitting), this.connected);
    const next = await answers.resume(sitting.answered);
    const fetched = await this.fetched(api, sitting, answers);
    const scale = {
      measured: content.card?.px_per_mm ?? null,
      ratio: content.window.device_pixel_ratio,
    };
    const { words, language, study } = this;
    const { pictures } = sitting;
    const keep = answers.keep.bind(answers);
    const setting = { study, words, language, scale, pictures, fetched, keep };
    const presenter = new Presenter(sitting.trials, setting);
    for (const block of blocksOf(sitting.trials, next)) {
      await this.before(api, sitting, block, next);
      await Promise.race([this.stage.run(presenter.timeline(block)), answers.refused]);
    }
    if (answers.waiting > 0) {
      const page = sendingPage(words, () => answers.waiting, answers.settled());
      await Promise.race([this.stage.show(page), answers.refused]);
    }
    await this.reach(() => api.finish());
    await this.kept.finish(api.token).catch(() => undefined);
    if (document.fullscreenElement !== null) await document.exitFullscreen().catch(() => undefined);
  }

  private async fetched(api: Api, sitting: SittingTold, answers: Answers): Promise<Pictures> {
    const pictures = new Pictures(api);
    const names = Object.keys(sitting.pictures);
    const page = loadingPage(this.words, (told) => this.reach(() => pictures.fetch(names, told)));
    const { problem } = await Promise.race([this.stage.show(page), answers.refused]);
    if (problem !== null) throw problem;
    return pictures;
  }

  /** The page before a block: instructions, the practice's end, a break, or a welcome back. */
  private async before(api: Api, sitting: SittingTold, block: readonly Trial[], next: number) {
    const first = block[0];
    if (first === undefined) return;
    const { words, stage, study } = this;
    const { n, all } = placeOf(sitting.trials, first);
    const resumed = first.trial === next && next > 0;
    const previous = sitting.trials[first.trial - 1];
    const question = study.questions.find(({ id }) => id === first.question);
    const asked =
      previous?.question === first.question ? null : said(question?.text ?? {}, this.language);
    const page = resumed
      ? resumedPage(
          words,
          fill(first.training ? words.resumed_training : words.resumed, { n, all }),
        )
      : first.trial === 0
        ? instructionsPage(words, this.instructions(first), study.sitting.training)
        : previous?.training
          ? trainingOverPage(words, all)
          : breakPage(words, n - 1, all, asked);
    while ((await stage.show(page)) === "stop") await this.stop(api);
    if (resumed && study.screen.full_screen && stage.simulation === null) await fillScreen();
    if (page.name === "resumed" || page.name === "break") await this.adapted();
  }

  /** Eyes that looked away get used to the grey again; simulated ones need not. */
  private async adapted(): Promise<void> {
    const { adaptation_s } = this.study.sitting;
    if (adaptation_s === 0 || this.stage.simulation !== null) return;
    await this.stage.show(adaptPage(this.words, adaptation_s));
  }

  /** What the study says, then how its first trial is answered. */
  private instructions(first: Trial): string[] {
    const { words, language, study } = this;
    return [
      said(study.instructions, language),
      ...taskOf(first).instructions(words, study.sitting),
    ];
  }

  private async stop(api: Api): Promise<void> {
    const chosen = await this.stage.show(stopPage(this.words));
    if (chosen === "later") throw new Ended("later");
    if (chosen === "withdraw") {
      await this.reach(() => api.withdraw());
      throw new Ended("withdrawn");
    }
  }
}

/** The study as its server tells it, asked for until it does. */
export function studyTold(connected: (yes: boolean) => void): Promise<Study> {
  return reach(studyOf, connected);
}
