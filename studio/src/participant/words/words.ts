/** Everything that participants read, in each language under the same keys. */

import type { Language } from "../../shared/language";
import { en } from "./en";
import { ja } from "./ja";

export type Words = Readonly<Record<keyof typeof en, string>>;

export const WORDS: Readonly<Record<Language, Words>> = { en, ja };
