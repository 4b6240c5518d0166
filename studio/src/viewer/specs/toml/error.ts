/** What is wrong with a TOML text, and where. */

export interface Place {
  readonly line: number;
  readonly column: number;
}

export class TomlError extends Error {
  constructor(
    readonly reason: string,
    /** undefined: of the whole text. */
    readonly place?: Place,
  ) {
    super(reason);
  }
}

/** Counted from 1, and in letters as Python counts them. */
export function lineAndColumn(text: string, position: number): Place {
  const before = text.slice(0, position).split("\n");
  return { line: before.length, column: Array.from(before.at(-1) ?? "").length + 1 };
}

/** A text as Python's `repr` has it, for keys in messages. */
export function quoted(text: string): string {
  const quote = text.includes("'") && !text.includes('"') ? '"' : "'";
  const letters = Array.from(text, (letter) => {
    const short = SHORT[letter];
    if (short) return short;
    if (letter === quote) return `\\${letter}`;
    if (letter === " " || !HIDDEN.test(letter)) return letter;
    const code = letter.codePointAt(0) ?? 0;
    const [sign, width] = code < 0x100 ? ["x", 2] : code < 0x10000 ? ["u", 4] : ["U", 8];
    return `\\${sign}${code.toString(16).padStart(width as number, "0")}`;
  });
  return quote + letters.join("") + quote;
}

const HIDDEN = /[\p{C}\p{Z}]/u;
const SHORT: Readonly<Record<string, string>> = {
  "\n": "\\n",
  "\r": "\\r",
  "\t": "\\t",
  "\\": "\\\\",
};
