/**
 * What is wrong with a key. Of a file, in English, it is the command line's own line; of a knob it is the
 * same with the labels of the page in the place of keys. Japanese is made from the forms of
 * `specs/verdict.ts` and `specs/rules.ts`.
 */

import type { Complaint } from "../specs/types";
import { type Call, type Rule, allowedJa, applied, quotedJa } from "./allowed";
import { fileJa } from "./files.ja";
import { KEYS as EN } from "./keys.en";
import { KEYS as JA } from "./keys.ja";
import { type Sentence, inEnglish } from "./sentence";
import { language } from "./speech";

const KINDS: Readonly<Record<string, string>> = {
  "a number": "数",
  "a whole number": "整数",
  "a list of numbers": "数の一覧",
  "a list of texts": "文字列の一覧",
  "a list of tables": "表の一覧",
  "text in quotes": "引用符で囲んだ文字列",
  "a table of keys": "キーの表",
};

const kindsJa = (words: string) =>
  words
    .split(" or ")
    .map((one) => KINDS[one] ?? one)
    .join("または");

/** What stands between "is" and the first semicolon. */
const VALUES: readonly Rule[] = [
  [
    /^given while (\S+) is (".*")$/,
    ([, key = "", is], call) => `${call(key)}が${is}なのに書かれています`,
  ],
  [
    /^missing while (\S+) is (".*")$/,
    ([, key = "", is], call) => `${call(key)}が${is}なのにありません`,
  ],
  [
    /^(".*") and (\S+) is (".*")$/,
    ([, is, key = "", other], call) => `${is}で、${call(key)}は${other}です`,
  ],
  [
    /^(.+) while (\S+) is (".*?")(, which hides it)?$/,
    ([, is, key = "", other, hidden], call) =>
      `${call(key)}が${other}なのに${is}です${hidden ? "（隠れて見えません）" : ""}`,
  ],
  [/^(.+), (\S+) mm from the centre$/, ([, is, mm]) => `${is}、中心から${mm} mmです`],
  [/^0, and so are .*: no layer would grow$/, () => "0で、ほかの二つも0なので、層が育ちません"],
  [/^at most (.+)$/, ([, most]) => `最大でも${most}です`],
];

const VERDICTS: readonly Rule[] = [
  [
    /^is not a key here; did you mean (.+)\?$/,
    ([, near]) => `このようなキーはありません。${near}のことですか。`,
  ],
  [
    /^is not a key here; keys here: (.+)$/,
    ([, keys = ""]) => `このようなキーはありません。使えるキー：${keys.replaceAll(", ", "、")}`,
  ],
  [
    /^is missing; allowed: (.+)$/,
    ([, allowed = ""], call) =>
      `ありません。使える値：${allowedJa(allowed, call) ?? kindsJa(allowed)}`,
  ],
  [
    /^is missing: give it, or give (\S+) or (\S+)$/,
    ([, one = "", other = ""], call) =>
      `ありません。これか、${call(one)}か${call(other)}を書いてください。`,
  ],
  [
    /^is missing: give it together with (\S+?)(?:, or give (\S+))?$/,
    ([, one = "", other], call) =>
      `ありません。${call(one)}と一緒に書くか、${other ? `代わりに${call(other)}を書いて` : "両方を除いて"}ください。`,
  ],
  [
    /^cannot stand beside (\S+): (.+)$/,
    ([, other = ""], call) => `${call(other)}と一緒には使えません。どちらか一つにしてください。`,
  ],
  [
    /^is of use only with (\S+), which is missing$/,
    ([, other = ""], call) => `${call(other)}がないと使えません。`,
  ],
  [
    /^hold (\d+) pearls together; allowed: (.+)$/,
    ([, n, most = ""], call) => `真珠が合わせて${n}個あります。使える数：${allowedJa(most, call)}`,
  ],
  [/^have no "\*"; wanted: /, () => 'に"*"がありません。今の真珠の場所が必要です。'],
  [
    /^is (".*"), which this page does not have; wanted: /,
    ([, name]) =>
      `は${name}ですが、このページにありません。先にそのファイルをここへ入れてください。`,
  ],
  [
    /^is (.+?)(?:; wanted: (.+?))?(?:; allowed(?: on this page)?: (.+?))?(?:; did you mean (".*")\?)?$/s,
    ([, is = "", wanted, allowed, near], call) =>
      [
        `値は${applied(VALUES, is, call) ?? `${is === "nothing" ? "空" : is}です`}。`,
        wanted && `必要なもの：${kindsJa(wanted)}。`,
        allowed && `使える値：${allowedJa(allowed, call) ?? allowed}。`,
        near && `${near}のことですか。`,
      ]
        .filter(Boolean)
        .join(""),
  ],
];

/** A verdict in Japanese; null where it is of no form that is known. */
export function verdictJa(verdict: string, call: Call): string | null {
  return applied(VERDICTS, verdict, call);
}

const withoutPlaces = (path: string) => path.replace(/\.\d+(?=\.|$)/g, "");

/** The label of a key on the page, for keys of the same table as another without their path too. */
function labels(names: typeof EN, path: string): (key: string) => string | undefined {
  const table = withoutPlaces(path).replace(/[^.]+$/, "");
  return (key) => {
    const plain = withoutPlaces(key);
    return (names[plain] ?? names[`${table}${plain}`])?.[0];
  };
}

/** What is wrong with a knob, which it calls as the page does. */
export function knobSays({ path, verdict, text }: Complaint): Sentence {
  if (verdict === undefined) return fileSays({ path, text });
  if (language.value === "ja") {
    const label = labels(JA, path);
    const call: Call = (key) => `「${label(key) ?? key}」`;
    const said = verdictJa(verdict, call);
    if (said !== null) return { lead: "", text: `${call(path)}：${quotedJa(said)}`, lang: "ja" };
  }
  const label = labels(EN, path);
  const named = verdict.replace(
    /(?<!")\b[a-z_]+(?:[._][a-z0-9_]+)+\b(?!")/g,
    (key) => label(key) ?? key,
  );
  return inEnglish(`${label(path) ?? path} ${named}`);
}

/** What is wrong with a file: in English the command line's line. */
export function fileSays({ path, verdict, text }: Complaint): Sentence {
  if (language.value !== "ja") return { lead: "", text, lang: "en" };
  const where = verdict === undefined ? "" : text.slice(0, text.indexOf(`${path} ${verdict}`));
  const said = verdict === undefined ? fileJa(text) : verdictJa(verdict, (key) => key);
  if (said === null) return inEnglish(text);
  return { lead: "", text: verdict === undefined ? said : `${where}${path}：${said}`, lang: "ja" };
}
