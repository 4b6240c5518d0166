/** The texts, keys and comments of TOML. */

import { quoted, type TomlError } from "./error";

const ESCAPES: Readonly<Record<string, string>> = {
  "\\b": "\b",
  "\\t": "\t",
  "\\n": "\n",
  "\\f": "\f",
  "\\r": "\r",
  '\\"': '"',
  "\\\\": "\\",
};
const CONTROL = /[\0-\x08\n-\x1f\x7f]/g;
const CONTROL_BUT_LINES = /[\0-\x08\x0b-\x1f\x7f]/g;

/** A text that is read from its beginning; `at` is the place of the next sign. */
export abstract class Strings {
  protected at = 0;

  constructor(protected readonly text: string) {}

  protected abstract error(reason: string): TomlError;

  /** The next sign, "" at the end. */
  protected sign(): string {
    return this.text.charAt(this.at);
  }

  /** Past these signs; gives the next one. */
  protected skip(signs: string): string {
    while (this.at < this.text.length && signs.includes(this.sign())) this.at += 1;
    return this.sign();
  }

  protected comment(): void {
    if (this.sign() !== "#") return;
    this.at += 1;
    const end = this.text.indexOf("\n", this.at);
    this.until(end < 0 ? this.text.length : end, CONTROL);
  }

  protected keyPart(): string {
    const sign = this.sign();
    if (sign === "'") return this.literal();
    if (sign === '"') {
      this.at += 1;
      return this.basic(false);
    }
    const start = this.at;
    while (/[A-Za-z0-9_-]/.test(this.sign())) this.at += 1;
    if (this.at === start) throw this.error("Invalid initial character for a key part");
    return this.text.slice(start, this.at);
  }

  protected anyString(): string {
    const isLiteral = this.sign() === "'";
    if (this.text.startsWith(isLiteral ? "'''" : '"""', this.at)) return this.lines(isLiteral);
    if (isLiteral) return this.literal();
    this.at += 1;
    return this.basic(false);
  }

  private literal(): string {
    this.at += 1;
    return this.ended("'", CONTROL);
  }

  /** The text up to its end sign, which is passed over. */
  private ended(end: string, forbidden: RegExp): string {
    const start = this.at;
    const stop = this.text.indexOf(end, start);
    if (stop < 0) {
      this.at = this.text.length;
      throw this.error(`Expected ${quoted(end)}`);
    }
    this.until(stop, forbidden);
    this.at = stop + end.length;
    return this.text.slice(start, stop);
  }

  private until(stop: number, forbidden: RegExp): void {
    const found = this.text.slice(this.at, stop).search(forbidden);
    if (found >= 0) {
      this.at += found;
      throw this.error(`Found invalid character ${quoted(this.sign())}`);
    }
    this.at = stop;
  }

  private lines(isLiteral: boolean): string {
    this.at += 3;
    if (this.sign() === "\n") this.at += 1;
    const text = isLiteral ? this.ended("'''", CONTROL_BUT_LINES) : this.basic(true);
    // Up to two more quotes belong to the text.
    const quote = isLiteral ? "'" : '"';
    let more = "";
    while (more.length < 2 && this.sign() === quote) {
      more += quote;
      this.at += 1;
    }
    return text + more;
  }

  private basic(ofLines: boolean): string {
    const forbidden = ofLines ? CONTROL_BUT_LINES : CONTROL;
    let text = "";
    for (;;) {
      const sign = this.sign();
      if (sign === "") throw this.error("Unterminated string");
      if (sign === '"' && (!ofLines || this.text.startsWith('"""', this.at))) {
        this.at += ofLines ? 3 : 1;
        return text;
      }
      if (sign === "\\") {
        text += this.escape(ofLines);
        continue;
      }
      if (sign.search(forbidden) >= 0) throw this.error(`Illegal character ${quoted(sign)}`);
      text += sign;
      this.at += 1;
    }
  }

  private escape(ofLines: boolean): string {
    const escape = this.text.slice(this.at, this.at + 2);
    this.at += 2;
    if (ofLines && ["\\ ", "\\\t", "\\\n"].includes(escape)) return this.joined(escape);
    if (escape === "\\u") return this.byNumber(4);
    if (escape === "\\U") return this.byNumber(8);
    const letter = ESCAPES[escape];
    if (letter === undefined) throw this.error("Unescaped '\\' in a string");
    return letter;
  }

  /** Nothing: the line goes on behind the white space. */
  private joined(escape: string): string {
    if (escape !== "\\\n") {
      const sign = this.skip(" \t");
      if (sign === "") return "";
      if (sign !== "\n") throw this.error("Unescaped '\\' in a string");
      this.at += 1;
    }
    this.skip(" \t\n");
    return "";
  }

  private byNumber(width: number): string {
    const digits = this.text.slice(this.at, this.at + width);
    if (digits.length !== width || !/^[0-9A-Fa-f]+$/.test(digits)) {
      throw this.error("Invalid hex value");
    }
    this.at += width;
    const code = Number.parseInt(digits, 16);
    if (code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) {
      throw this.error("Escaped character is not a Unicode scalar value");
    }
    return String.fromCodePoint(code);
  }
}
