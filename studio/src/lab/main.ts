/** The laboratory: where an experimenter steers a study and sees what comes of it. */

import "../shared/style.css";
import "./lab.css";
import "./forms.css";
import "./tables.css";
import "./scale.css";

import { element } from "../shared/dom";
import { Problem } from "../shared/http";
import { fill, type Language } from "../shared/language";
import { Lab, type Progress, type Study } from "./api";
import type { Desk, Kept } from "./desk";
import { loginAgain, loginForm } from "./login";
import { languages, Page } from "./page";
import { rememberedLanguage, rememberLanguage, Speech } from "./words/speech";

/** How often the server is asked how far the study is; more slowly while it does not answer. */
const EVERY_MS = 3_000;
const SLOWLY_MS = 10_000;

class Laboratory {
  private readonly lab = new Lab(() => this.ended());
  private readonly kept: Kept = {
    tab: "overview",
    explained: new Set(),
    shown: "everyone",
    question: "",
    simulated: false,
    links: [],
  };
  private speech = new Speech(rememberedLanguage());
  private study: Study | null = null;
  private page: Page | null = null;
  private timer = 0;
  private looking = false;
  private again = false;
  private lastAt: Date | null = null;
  private last: Progress | null = null;

  async start(): Promise<void> {
    window.addEventListener("hashchange", () => this.page?.open(location.hash.slice(1)));
    document.addEventListener("visibilitychange", () => {
      if (!document.hidden) this.look();
    });
    try {
      if ((await this.lab.whoAmI()) === null) this.showLogin();
      else await this.showPage();
    } catch (problem) {
      this.showLogin(problem);
    }
  }

  private showLogin(problem?: unknown): void {
    clearTimeout(this.timer);
    this.page = null;
    const { speech } = this;
    const words = speech.words.login;
    document.title = words.title;
    document.documentElement.lang = speech.language;
    const form = loginForm(this.lab, speech, "", () => {
      void this.showPage().catch((failed: unknown) => this.showLogin(failed));
    });
    const speak = (language: Language) => this.speak(language, () => this.showLogin(problem));
    put(
      element(
        "main",
        { class: "door" },
        languages(speech, speak),
        element("h1", {}, words.title),
        element("p", { class: "soft" }, words.lead),
        ...(problem === undefined ? [] : [element("p", { class: "trouble" }, this.told(problem))]),
        form,
      ),
    );
    form.querySelector("input")?.focus();
  }

  private async showPage(): Promise<void> {
    this.study = await this.lab.study();
    this.kept.question ||= this.study.questions[0]?.id ?? "";
    this.makePage();
  }

  private makePage(): void {
    const { speech, lab, study, kept } = this;
    if (study === null) return;
    document.documentElement.lang = speech.language;
    const desk: Desk = { lab, speech, study, kept, act: (work) => this.act(work) };
    this.page = new Page(desk, {
      logOut: () => void this.logOut(),
      speak: (language) => this.speak(language, () => this.makePage()),
      look: () => this.show(),
    });
    put(this.page.node);
    this.page.open(location.hash.slice(1));
  }

  /** Show at once what is known, and look what is new. */
  private show(): void {
    if (this.last !== null) void this.page?.update(this.last).catch(() => undefined);
    this.look();
  }

  private speak(language: Language, again: () => void): void {
    if (language === this.speech.language) return;
    rememberLanguage(language);
    this.speech = new Speech(language);
    again();
    document.querySelector<HTMLElement>(`button.language[lang=${language}]`)?.focus();
  }

  private async logOut(): Promise<void> {
    if (await this.act(() => this.lab.logout())) {
      this.last = null;
      this.kept.links.length = 0;
      this.showLogin();
    }
  }

  /** Do something and look at once what came of it; say so if it fails. */
  private async act(work: () => Promise<unknown>): Promise<boolean> {
    try {
      await work();
      this.page?.say("", false);
      this.look();
      return true;
    } catch (problem) {
      if (!isEnd(problem)) this.page?.say(this.told(problem), false);
      this.look();
      return false;
    }
  }

  /** Ask how far the study is, now and from now on every few seconds. */
  private look(): void {
    clearTimeout(this.timer);
    this.again = this.looking;
    if (this.looking || this.page === null) return;
    this.looking = true;
    void this.lookOnce().then((wait_ms) => {
      this.looking = false;
      clearTimeout(this.timer);
      if (this.again) return this.look();
      if (this.page !== null && !document.hidden && wait_ms > 0) {
        this.timer = window.setTimeout(() => this.look(), wait_ms);
      }
    });
  }

  private async lookOnce(): Promise<number> {
    try {
      this.last = await this.lab.progress();
      this.lastAt = new Date();
      await this.page?.update(this.last);
      this.page?.say("", true);
      return EVERY_MS;
    } catch (problem) {
      if (isEnd(problem)) return 0;
      const passes = problem instanceof Problem && problem.passes;
      const { offline } = this.speech.words.trouble;
      const time = this.lastAt === null ? "–" : this.speech.moment(this.lastAt);
      this.page?.say(passes ? fill(offline, { time }) : this.told(problem), true);
      return SLOWLY_MS;
    }
  }

  /** The server does not know us any more: log in over the page, and go on. */
  private ended(): void {
    if (this.page === null) return;
    loginAgain(this.lab, this.speech, () => this.look());
  }

  private told(problem: unknown): string {
    const { refused, failed } = this.speech.words.trouble;
    const text = problem instanceof Error ? problem.message : String(problem);
    const no = problem instanceof Problem && problem.status >= 400 && problem.status < 500;
    return fill(no ? refused : failed, { problem: text });
  }
}

function isEnd(problem: unknown): boolean {
  return problem instanceof Problem && problem.status === 401;
}

function put(node: HTMLElement): void {
  const before = document.body.querySelector(":scope > .lab, :scope > .door");
  if (before === null) document.body.prepend(node);
  else before.replaceWith(node);
}

void new Laboratory().start();
