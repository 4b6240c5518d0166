/** What a key allows, in Japanese: the phrases of `nacreous/spec/` and `specs/rules.ts`. */

import { UNITS } from "./choices";

/** What a key is called where it is spoken of. */
export type Call = (key: string) => string;

export type Rule = readonly [
  pattern: RegExp,
  said: (found: readonly string[], call: Call) => string,
];

const NUMBER = String.raw`-?\d+(?:\.\d+)?(?:e[+-]?\d+)?`;

function unit(text = ""): string {
  const name = text.trim();
  const said = UNITS[name]?.ja ?? name;
  return said === "" || said === "°" ? said : ` ${said}`;
}

/** `"a", "b" or "c"`, with words between them. */
const texts = (list: string) => list.replace(/,? or /, ", ").replaceAll(", ", "、");

const LIGHTS = /^((?:"auto", )?"A", "C".*?), (?:or )?a colour temperature from 1000K to 25000K$/;

const RANGES: readonly Rule[] = [
  [
    new RegExp(`^(above )?(${NUMBER}) to (below )?(${NUMBER})( [a-z ]+)?$`),
    ([, above, from, below, to, of]) =>
      above || below
        ? `${from}${above ? "より大きく" : "以上"}${to}${unit(of)}${below ? "未満" : "以下"}`
        : `${from}〜${to}${unit(of)}`,
  ],
  [
    new RegExp(`^three numbers from (${NUMBER}) to (${NUMBER})( mm)?(, not all 0)?$`),
    ([, from, to, of, not]) =>
      `${from}〜${to}${unit(of)}の三つの数${not ? "（すべて0は不可）" : ""}`,
  ],
  [
    /^(\d+) to (\d+) numbers, each above 0 to (\d+) nm$/,
    ([, from, to, most]) => `${from}〜${to}個の数、どれも0より大きく${most} nm以下`,
  ],
  [
    /^(\d+) to (\d+) tables, each headed (.+)$/,
    ([, from, to, head]) => `${from}〜${to}個の表、見出しはどれも${head}`,
  ],
  [/^one line of 1 to (\d+) characters$/, ([, most]) => `1〜${most}文字の一行`],
];

const CHOICES: readonly Rule[] = [
  [LIGHTS, ([, list = ""]) => `${texts(list.replaceAll(" to ", "〜"))}、1000K〜25000Kの色温度`],
  [/^("[^"]*"(?:(?:, | or )"[^"]*")*)$/, ([, list = ""]) => `${texts(list)}のどれか`],
  [
    /^("procedural" or )?a path ending in ([.a-z, ]+?)$/,
    ([, own, ends = ""]) => `${own ? '"procedural"か、' : ""}${texts(ends)}で終わるファイル名`,
  ],
  [/^"#rrggbb", six hexadecimal digits of sRGB$/, () => '"#rrggbb"（sRGBの16進数6桁）'],
  [
    /^"MM-DD" of every year but 02-29(, or "YYYY-MM-DD")?$/,
    ([, dated]) => `02-29を除く"MM-DD"${dated ? 'か、"YYYY-MM-DD"' : ""}`,
  ],
  [/^a name that `nacreous presets nacre` lists$/, () => "nacreous presets nacreが並べる名前"],
  [
    /^(\d+) to (\d+) pearl presets, paths ending in .toml, "\*" or "\*0" to "\*999"$/,
    ([, from, to]) => `${from}〜${to}個の、真珠の見本、.tomlで終わるファイル名、"*"、"*0"〜"*999"`,
  ],
  [
    /^a number n above 0 to 10, \[n, k\] with k from 0 to 10, (\{.*\}), or (.*)$/,
    ([, table, list = ""]) =>
      `0より大きく10以下の数n、kが0〜10の[n, k]、${table}、または${texts(list)}`,
  ],
];

/** Of rules between keys. */
const BETWEEN: readonly Rule[] = [
  [
    /^1 day to 20 years after (\S+), which is (".*")$/,
    ([, key = "", day], call) => `${call(key)}（${day}）の1日後から20年後まで`,
  ],
  [/^both with a year or both without$/, () => "どちらも年つき、またはどちらも年なし"],
  [
    /^up to half of (\S+), which is (.+)$/,
    ([, key = "", most], call) => `${call(key)}の半分、${most}まで`,
  ],
  [
    /^less than (\S+), which is (.+)$/,
    ([, key = "", most = ""], call) =>
      `${call(key)}の${most.replace("cycles per mm", "周期/mm")}より小さい値`,
  ],
  [
    /^at least (\d+) x (\S+) x half of diameter_mm, (.+)$/,
    ([, n, key = "", least], call) =>
      `${n} × ${call(key)} × ${call("diameter_mm")}の半分、${least}以上`,
  ],
  [
    /^0, or (.+) or more \(is it in um\?\)$/,
    ([, least]) => `0、または${least}以上（µmで書いていませんか）`,
  ],
  [
    /^a layer of (.+) or more \(is it in um\?\)$/,
    ([, least]) => `${least}以上の層が一つは必要（µmで書いていませんか）`,
  ],
  [/^only with (\S+) = (".*")$/, ([, key = "", value], call) => `${call(key)}が${value}のときだけ`],
  [/^only with (".*")$/, ([, value]) => `${value}のときだけ`],
  [/^k = 0; what absorbs is (\S+)$/, ([, key = ""], call) => `k = 0（光を吸うのは${call(key)}）`],
  [
    /^an index that is the same in all directions, such as (\S+)$/,
    ([, such]) => `どの向きにも同じ屈折率、たとえば${such}`,
  ],
  [/^a path with "panorama", and only with it$/, () => '"panorama"のときだけ、ファイル名'],
  [
    /^(more than|at least) (.+), clear of any pearl$/,
    ([, how, least]) => `真珠から離れた${least}${how === "at least" ? "以上" : "より遠く"}`,
  ],
  [/^three numbers, not all 0$/, () => "すべてが0ではない三つの数"],
  [/^at least one of the three above 0$/, () => "三つのうち一つは0より大きく"],
  [/^at most (\d+)$/, ([, most]) => `${most}まで`],
  [/^pearl presets and "\*"$/, () => '真珠の見本と"*"'],
];

/** Texts in quotes as Japanese quotes them, where they are typed into fields without any. */
export function quotedJa(text: string): string {
  return text.replace(/"([^"]*)"/g, "「$1」");
}

export function applied(rules: readonly Rule[], text: string, call: Call): string | null {
  for (const [pattern, said] of rules) {
    const found = pattern.exec(text);
    if (found !== null) return said(found, call);
  }
  return null;
}

/** What is allowed, in Japanese; null of a phrase that is not known. */
export function allowedJa(phrase: string, call: Call): string | null {
  const path = /^(.*), or a path ending in (\S+)$/.exec(phrase);
  if (path !== null) {
    const before = allowedJa(path[1] ?? "", call);
    return before === null ? null : `${before}、または${path[2]}で終わるファイル名`;
  }
  return applied([...RANGES, ...CHOICES, ...BETWEEN], phrase, call);
}
