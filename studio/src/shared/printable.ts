/** Text from outside as it may be shown on a page. */

const HIDDEN = /[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu;
/** Ends of lines, joiners within Persian words and emoji, tags of flags. */
const KEPT = /[\n\u200c\u200d\u{e0020}-\u{e007f}]/u;

/**
 * The text with control and invisible characters as \\u and their number: they could turn the
 * direction of what follows, or make two names look alike.
 */
export function printable(text: string): string {
  return text.replace(HIDDEN, (letter) => (KEPT.test(letter) ? letter : escaped(letter)));
}

function escaped(letter: string): string {
  return `\\u${(letter.codePointAt(0) ?? 0).toString(16).padStart(4, "0")}`;
}
