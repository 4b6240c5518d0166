/** The laboratory's words in the language that was chosen, and how it writes times and lengths. */

import { fill, preferred, type Language } from "../../shared/language";
import { en, type Words } from "./en";
import { ja } from "./ja";

const ALL: Record<Language, Words> = { en, ja };
export const LANGUAGES: readonly Language[] = ["en", "ja"];
const KEY = "nacreous-lab-language";

/** Words, times and durations in one language. */
export class Speech {
  readonly words: Words;
  private readonly clock: Intl.DateTimeFormat;

  constructor(readonly language: Language) {
    this.words = ALL[language];
    this.clock = new Intl.DateTimeFormat(language === "ja" ? "ja-JP" : "en-GB", {
      month: "short",
      day: "numeric",
      hour: "2-digit",
      minute: "2-digit",
      second: "2-digit",
    });
  }

  /** A moment, by this computer's clock. */
  moment(iso: string | Date): string {
    const at = new Date(iso);
    return Number.isNaN(at.getTime()) ? String(iso) : this.clock.format(at);
  }

  /** How long: in seconds up to a minute, then in minutes and seconds, then coarser. */
  duration(seconds: number): string {
    const units = this.words.units;
    const whole = Math.max(0, Math.round(seconds));
    if (whole < 60) return fill(units.s, { n: whole });
    if (whole < 3600) return fill(units.min_s, { min: Math.floor(whole / 60), s: whole % 60 });
    return this.roughly(whole);
  }

  /** How long, in one unit. */
  roughly(seconds: number): string {
    const units = this.words.units;
    const whole = Math.max(0, Math.round(seconds));
    if (whole < 60) return fill(units.s, { n: whole });
    if (whole < 3600) return fill(units.min, { n: Math.floor(whole / 60) });
    if (whole < 86400) return fill(units.h, { n: Math.floor(whole / 3600) });
    return fill(units.d, { n: Math.floor(whole / 86400) });
  }

  /** How long ago; a server's clock a little ahead of ours is now. */
  ago(iso: string, now: Date): string {
    const seconds = (now.getTime() - new Date(iso).getTime()) / 1000;
    if (seconds < 5) return this.words.people.just_now;
    return fill(this.words.people.ago, { duration: this.roughly(seconds) });
  }
}

/** The language chosen before, otherwise the browser's. */
export function rememberedLanguage(): Language {
  let kept: string | null = null;
  try {
    kept = localStorage.getItem(KEY);
  } catch {
    // Without storage the browser's language serves.
  }
  const found = LANGUAGES.find((language) => language === kept);
  return found ?? preferred(LANGUAGES, navigator.languages);
}

export function rememberLanguage(language: Language): void {
  try {
    localStorage.setItem(KEY, language);
  } catch {
    // Chosen for this page alone, then.
  }
}
