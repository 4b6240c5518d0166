/** Why something was not measured, drawn or saved, in the page's language. */

import reasons from "../../../../nacreous/card/reasons.json";
import { type Rule, applied } from "./allowed";
import { knobSays } from "./complaints";
import { fileJa } from "./files.ja";
import { type Sentence, inEnglish } from "./sentence";
import { language } from "./speech";

/** What `crates/measure` says, as cards have it too. */
const MEASURES: readonly Rule[] = reasons.map(({ pattern, ja }) => [
  new RegExp(pattern),
  ([, ...found]) => `${ja.replace(/\{(\d)\}/g, (_, place) => found[Number(place)] ?? "")}。`,
]);

/** Why something was not measured, drawn or saved. */
export function refusalSays(text: string): Sentence {
  if (language.value !== "ja") return { lead: "", text, lang: "en" };
  const said = applied(MEASURES, text, (key) => key) ?? fileJa(text);
  if (said !== null) return { lead: "", text: said, lang: "ja" };
  const ofKey =
    /^(?:.*: )?(?:pearl\.|scene\.)?([a-z_]+(?:\.[a-z0-9_]+)*) (is .+; allowed: .+)$/s.exec(text);
  const [, path = "", verdict = ""] = ofKey ?? [];
  return ofKey === null ? inEnglish(text) : knobSays({ path, verdict, text });
}
