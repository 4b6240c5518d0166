/** A sentence of the page, which may have to be in English. */

import { type Language, language } from "./speech";

export interface Sentence {
  /** What leads to it, in the page's language. */
  readonly lead: string;
  readonly text: string;
  readonly lang: Language;
}

/** An English line on the page, which says so where the page speaks Japanese. */
export function inEnglish(text: string): Sentence {
  return { lead: language.value === "ja" ? "英語の説明：" : "", text, lang: "en" };
}
