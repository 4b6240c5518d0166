/** The two languages, and words with places to fill. */

import type { StudyTold, Words } from "./wire";

export type Language = StudyTold["languages"][number];

/** What each language calls itself. */
export const NAMES: Record<Language, string> = { en: "English", ja: "日本語" };

/** The first language that the browser asks for among those offered, otherwise the first offered. */
export function preferred(offered: readonly Language[], asked: readonly string[]): Language {
  for (const tag of asked) {
    const found = offered.find((language) => tag.toLowerCase().split("-")[0] === language);
    if (found !== undefined) return found;
  }
  return offered[0] ?? "en";
}

/** A study's words in a language; where they are missing, in any. */
export function said(words: Words, language: Language): string {
  return words[language] ?? words.en ?? words.ja ?? "";
}

/** Words with each {place} filled. */
export function fill(words: string, places: Record<string, string | number>): string {
  return words.replace(/\{(\w+)\}/g, (place, name: string) => apart(String(places[name] ?? place)));
}

/**
 * A text that is read from right to left, set apart from the words around it, which would change
 * places otherwise; every other text as it is.
 */
export function apart(text: string): string {
  return /[\p{Script=Hebrew}\p{Script=Arabic}\p{Script=Syriac}\p{Script=Thaana}\p{Script=Nko}]/u.test(
    text,
  )
    ? `\u2068${text}\u2069`
    : text;
}
