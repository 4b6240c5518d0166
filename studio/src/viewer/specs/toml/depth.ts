/** A bound on how deeply a TOML text is nested: `nacreous/toml_text.py`. */

import { lineAndColumn, TomlError } from "./error";

/** Levels of brackets, and parts of a key, that are read. */
const DEEPEST = 32;

/** Strings and comments are passed over whole; a string that never ends is left to the parser. */
const TOKENS =
  /"""(?:[^"\\]|\\[^]|"(?!""))*"{3,5}|'''(?:[^']|'(?!''))*'{3,5}|"(?:[^"\\\n]|\\[^])*"|'[^'\n]*'|#[^\n]*|[[\]{}.,=\n]/g;

/** Throws a TomlError at the sign that goes too deep. */
export function checkDepth(text: string): void {
  let brackets = 0;
  let parts = 0;
  for (const token of text.matchAll(TOKENS)) {
    const sign = token[0];
    if (sign === ".") {
      parts += 1;
    } else if (sign === "[" || sign === "{") {
      brackets += 1;
      parts = 0;
    } else if (sign === "]" || sign === "}") {
      brackets = Math.max(brackets - 1, 0);
      parts = 0;
    } else if (sign === "," || sign === "=" || sign === "\n") {
      parts = 0;
    }
    if (Math.max(brackets, parts + 1) > DEEPEST) {
      throw new TomlError(
        `nested too deeply; allowed: ${DEEPEST} levels`,
        lineAndColumn(text, token.index),
      );
    }
  }
}
