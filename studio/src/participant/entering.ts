/** From the first page to a sitting that has begun: language, consent, what is asked of a person. */

import { Problem } from "../shared/http";
import { preferred, said } from "../shared/language";
import type { Language } from "../shared/language";
import type { Api, SittingTold, Study } from "./api";
import { consentPage } from "./pages/consent";
import { Ended } from "./pages/ends";
import { groupsPage } from "./pages/groups";
import { languagePage } from "./pages/language";
import type { Stage } from "./stage";
import { WORDS } from "./words/words";

export class Entering {
  constructor(
    private readonly stage: Stage,
    private readonly study: Study,
    private readonly api: Api,
    private readonly reach: <T>(request: () => Promise<T>) => Promise<T>,
    private readonly speak: (language: Language) => void,
    private readonly parameters: Record<string, string>,
  ) {}

  /** Let somebody in who was not here before. `keep` keeps the token before it is first used. */
  async enter(keep: () => Promise<void>): Promise<SittingTold> {
    const language = await this.agree(await this.language());
    const words = WORDS[language];
    const factors = this.study.groups;
    const groups =
      factors.length > 0 ? await this.stage.show(groupsPage(words, language, factors)) : {};
    await keep();
    await this.reach(() => this.api.enter(language, groups, this.parameters));
    return this.consented();
  }

  /** Ask somebody again who entered, and left before the server heard that they agree. */
  async again(sitting: SittingTold): Promise<SittingTold> {
    await this.agree(sitting.language, []);
    return this.consented();
  }

  private async consented(): Promise<SittingTold> {
    await this.reach(() => this.api.consent());
    return this.reach(() => this.api.sitting());
  }

  private async language(): Promise<Language> {
    const offered = this.study.languages;
    const first = preferred(offered, navigator.languages);
    if (offered.length < 2) return first;
    const chosen = await this.stage.show(languagePage(offered, first));
    this.speak(chosen);
    return chosen;
  }

  private async agree(first: Language, offered = this.study.languages): Promise<Language> {
    let language = first;
    for (;;) {
      this.speak(language);
      const others = offered.filter((other) => other !== language);
      const text = said(this.study.consent, language);
      const demo = this.study.purpose === "demo";
      const chosen = await this.stage.show(consentPage(WORDS[language], text, others, demo));
      if (chosen === "agree") return language;
      if (chosen === "decline") throw new Ended("declined");
      language = chosen;
    }
  }
}

/** Why somebody may not enter now, if that is so. `linked`: with a link of their own. */
export function barred(study: Study, linked: boolean): "paused" | "closed" | "invited" | null {
  if (study.state !== "open") return study.state;
  return study.registration === "invited" && !linked ? "invited" : null;
}

/** The sitting of a token, or null for a token that has not entered. */
export async function sittingOf(api: Api): Promise<SittingTold | null> {
  try {
    return await api.sitting();
  } catch (reason) {
    if (reason instanceof Problem && reason.kind === "token") return null;
    throw reason;
  }
}
