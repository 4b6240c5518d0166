/** The page's language, and what it says in it. */

import { computed, signal } from "@preact/signals";
import { type Language, fill, preferred } from "../../shared/language";
import { CHOICES, UNITS } from "./choices";
import { EN, type Word } from "./en";
import { JA } from "./ja";
import { KEYS as KEYS_EN } from "./keys.en";
import { KEYS as KEYS_JA } from "./keys.ja";

export type { Language } from "../../shared/language";

const REMEMBERED = "nacreous.viewer.language";
const ALL: readonly Language[] = ["en", "ja"];

/** From the address, from the last visit, or what the browser asks for. */
function firstLanguage(): Language {
  const asked = new URLSearchParams(location.search).get("lang");
  return preferred(ALL, [asked ?? "", remembered() ?? "", ...navigator.languages]);
}

/** In a frame of another page there may be no storage. */
function remembered(): string | null {
  try {
    return localStorage.getItem(REMEMBERED);
  } catch {
    return null;
  }
}

export const language = signal<Language>(firstLanguage());

export function speak(next: Language): void {
  language.value = next;
  sayInAddress(next);
  try {
    localStorage.setItem(REMEMBERED, next);
  } catch {
    // then it is not remembered
  }
}

/** An address that asks for a language asks for this one from now on. */
function sayInAddress(next: Language): void {
  const url = new URL(location.href);
  if (!url.searchParams.has("lang")) return;
  url.searchParams.set("lang", next);
  history.replaceState(null, "", url.href);
}

const words = computed(() => (language.value === "ja" ? JA : EN));
const keys = computed(() => (language.value === "ja" ? KEYS_JA : KEYS_EN));

/** A word or sentence, its places filled. */
export function t(word: Word, places: Record<string, string | number> = {}): string {
  return fill(words.value[word], places);
}

/** What a declared key is called. */
export function nameOf(key: string): string {
  return keys.value[key]?.[0] ?? key.slice(key.lastIndexOf(".") + 1);
}

/** One plain sentence about a declared key. */
export function saysOf(key: string): string {
  return keys.value[key]?.[1] ?? "";
}

export function choiceName(choice: string): string {
  return CHOICES[choice]?.[language.value] ?? choice;
}

export function unitName(unit: string | undefined): string {
  return unit === undefined ? "" : (UNITS[unit]?.[language.value] ?? unit);
}
