/** Whole lines about files, links and workers, in Japanese. */

import { type Rule, applied } from "./allowed";

const plain = (key: string) => key;

/** Reasons of a file, a link or a worker, after the file's name. */
const FILES: readonly Rule[] = [
  [
    /^line (\d+), column (\d+): not TOML: (.+)$/s,
    ([, line, column, why]) => `${line}行目の${column}文字目：TOMLとして読めません（${why}）`,
  ],
  [/^not TOML: (.+)$/s, ([, why]) => `TOMLとして読めません（${why}）`],
  [
    /^line (\d+): is not UTF-8; wanted: a TOML file$/,
    ([, line]) => `${line}行目：UTF-8ではありません。TOMLファイルが必要です。`,
  ],
  [
    /^is a binary file; wanted: a TOML file$/,
    () => "文字のファイルではありません。TOMLファイルが必要です。",
  ],
  [
    /^is longer than (\d+) bytes, the most that is read$/,
    ([, n]) => `長すぎます。読めるのは${n}バイトまでです。`,
  ],
  [
    /^the file is empty; wanted: at least one key, such as name$/,
    () => "空のファイルです。nameなど、キーが一つは必要です。",
  ],
  [
    /^the keys show neither a pearl nor a scene; /,
    () =>
      "真珠のキーも場面のキーもありません。真珠ならnacreやdiameter_mm、場面ならcameraやlampsなどのキーが必要です。",
  ],
  [
    /^is a (pearl|scene) file; wanted: a (pearl|scene) file$/,
    ([, is]) =>
      is === "pearl"
        ? "真珠のファイルです。場面のファイルが必要です。"
        : "場面のファイルです。真珠のファイルが必要です。",
  ],
  [/^holds a number too long to be read$/, () => "長すぎて読めない数があります。"],
  [
    /^is (\d+) bytes long; allowed on this page: at most (\d+)$/,
    ([, n, most]) => `${n}バイトあります。このページで読めるのは${most}バイトまでです。`,
  ],
  [
    /^is (\d+) x (\d+) pixels; allowed on this page: at most (\d+) pixels in all$/,
    ([, w, h, most]) =>
      `${w} × ${h}画素あります。このページで読めるのは合わせて${most}画素までです。`,
  ],
  [/^more than 1 MB; allowed: up to 1 MB$/, () => "1 MBを超えています。読めるのは1 MBまでです。"],
  [
    /^not text; allowed: a table in UTF-8, UTF-16 or Latin-1$/,
    () => "文字のファイルではありません。UTF-8、UTF-16、Latin-1の表が必要です。",
  ],
  [
    /^was not opened; allowed: (\d+) files at once$/,
    ([, most]) => `開きませんでした。一度に開けるのは${most}個までです。`,
  ],
  [
    /^no pearl found in it; wanted: a photograph of one pearl, with (\d+) x \d+ pixels/,
    ([, n]) =>
      `真珠が見つかりません。ハイライトのない部分が${n} × ${n}画素以上ある、真珠一つの写真が必要です。`,
  ],
  [
    /^the photograph has (\d+) x (\d+) pixels; allowed: at least side_px = (\d+) each way$/,
    ([, h, w, least]) =>
      `写真が${w} × ${h}画素しかありません。どちらも${least}画素以上が必要です。`,
  ],
  [/^is empty \(0 bytes\)$/, () => "空のファイルです（0バイト）。"],
  [
    /^is not a picture that can be read here; allowed: (.+)$/,
    ([, formats = ""]) =>
      `読める画像ではありません。読めるのは${formats.replaceAll(", ", "、")}です。`,
  ],
  [
    /^is damaged or cut short \((.+)\)$/,
    ([, why = ""]) => `壊れているか、途中で切れています（${DAMAGE[why] ?? why}）。`,
  ],
  [
    /^is (\d+) bytes long; allowed: at most (\d+)$/,
    ([, n, most]) => `${n}バイトあります。読めるのは${most}バイトまでです。`,
  ],
  [
    /^is (\d+) x (\d+) pixels; allowed: 1 to (\d+) a side and at most (\d+) pixels in all$/,
    ([, w, h, side, most]) =>
      `${w} × ${h}画素あります。読めるのは一辺${side}画素、合わせて${most}画素までです。`,
  ],
  [
    /^holds several pearls; /,
    () => "真珠がいくつも入っています。このページで使えるのは一つの画像だけです。",
  ],
  [
    /^has no recipe; /,
    () => "もとの真珠と場面が入っていません。nacreous renderがつくったままの画像が必要です。",
  ],
  [/^cannot be read$/, () => "読み込めません。"],
  [/^takes more memory than this page has$/, () => "このページで使えるメモリーでは足りません。"],
  [/^takes too long$/, () => "時間がかかりすぎたため、やめました。"],
];

const WHOLE: readonly Rule[] = [
  [/^\.\.\. and (\d+) more problems$/, ([, n]) => `…ほかに${n}件あります`],
  [
    /^The link cannot be used: (.+); wanted: a whole link, as it was copied$/,
    ([, why = ""]) =>
      `リンクを使えません：${LINKS[why] ?? why}。コピーしたままの、欠けていないリンクが必要です。`,
  ],
];

const DAMAGE: Readonly<Record<string, string>> = {
  "the JPEG ends before its picture": "画像の途中で終わっています",
  "the file ends before its pixels": "画像の途中で終わっています",
  "its header does not end": "ヘッダーが途中で終わっています",
  "it ends before its picture does": "画像の途中で終わっています",
  "a checksum does not match what it is of": "検査の値が合いません",
  "its data cannot be decoded": "データを読めません",
};

const LINKS: Readonly<Record<string, string>> = {
  "it does not begin with 1.": "1.で始まっていません",
  "a newer Nacreous made it": "より新しいNacreousのリンクです",
  "it has letters that no link has": "リンクにない文字があります",
  "a part of it is missing or changed": "一部が欠けているか、変わっています",
  "it holds no pearl and scene": "真珠と場面が入っていません",
  "it is of a preset that is not here": "ここにない見本をもとにしています",
};

/** A whole line about a file or a link in Japanese; null where it is of no form that is known. */
export function fileJa(text: string): string | null {
  const whole = applied([...WHOLE, ...FILES], text, plain);
  if (whole !== null) return whole;
  for (let at = text.indexOf(": "); at >= 0; at = text.indexOf(": ", at + 2)) {
    const said = applied(FILES, text.slice(at + 2), plain);
    if (said !== null) return `${text.slice(0, at)}: ${said}`;
  }
  return null;
}
