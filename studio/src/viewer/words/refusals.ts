/** Why something was not measured, drawn or saved, in the page's language. */

import { type Rule, applied } from "./allowed";
import { knobSays } from "./complaints";
import { fileJa } from "./files.ja";
import { type Sentence, inEnglish } from "./sentence";
import { language } from "./speech";

/** `crates/measure` and what else the instruments are refused. */
const MEASURES: readonly Rule[] = [
  [
    /^no spot of up to (\S+) radians differs by (\S+) and more in (\S+); larger ones, and relief that differs by less, cannot be told here$/,
    ([, radius, n, space]) =>
      `半径${radius}ラジアンまでで、${space}の差が${n}以上の点はありません。それより大きな点と、それより淡い凹凸は、この画像では見分けられません。`,
  ],
  [
    /^some spots differ by little more than (\S+) in (\S+); how a picture is made \(pixels, JPEG\) may change the area by (\S+) % of the pearl$/,
    ([, n, space, area]) =>
      `${space}の差が${n}をわずかに超えるだけの点があります。画像の作り方（画素数、JPEG）により、面積が真珠の${area} %ほど変わることがあります。`,
  ],
  [
    /^the pearl is no sphere: its diameters differ by more than (\S+) %$/,
    ([, n]) => `真珠が球ではありません。直径の差が${n} %を超えています。`,
  ],
  [
    /^the pearl has (\d+) pixels of radius; wanted: (\d+) or more$/,
    ([, n, least]) => `真珠の半径が${n}画素です。${least}画素以上が必要です。`,
  ],
  [/^all of the pearl is clipped$/, () => "真珠全体が白飛びしています。"],
  [/^the lamp's image lies too near to the outline$/, () => "照明の映り込みが輪郭に近すぎます。"],
  [
    /^a degree of the surface is less than a pixel, or the outline is near$/,
    () => "面の1度が1画素より小さいか、輪郭が近すぎます。",
  ],
  [
    /^the lamp's image and clipped light leave too little of the pearl$/,
    () => "照明の映り込みと白飛びを除くと、真珠がほとんど残りません。",
  ],
  [/^the pearl is too small$/, () => "真珠が小さすぎます。"],
  [
    /^no lamp's image stands out from the light around it$/,
    () => "周りの光から際立つ照明の映り込みがありません。",
  ],
  [/^the lamp's image runs into the outline$/, () => "照明の映り込みが輪郭にかかっています。"],
  [
    /^the highlight is clipped in (\S+) % of its pixels$/,
    ([, n]) => `ハイライトの画素の${n} %が白飛びしています。`,
  ],
  [
    /^the brightest light runs into the outline, or over much of the pearl$/,
    () => "もっとも明るい光が輪郭にかかるか、真珠の広い部分を覆っています。",
  ],
  [
    /^the lamp's image is (\S+) pixels wide from its middle to half level; wanted: (\S+) or more, in a larger picture$/,
    ([, n, least]) =>
      `照明の映り込みが、中心から半分の明るさまで${n}画素しかありません。もっと大きな画像で、${least}画素以上が必要です。`,
  ],
  [
    /^no pearl: no round outline stands out \(an edge in (\S+) % of all directions; wanted: (\S+) %\)$/,
    ([, n, least]) =>
      `真珠が見つかりません。丸い輪郭が際立ちません（縁が見えるのは全方向の${n} %、必要なのは${least} %）。`,
  ],
  [
    /^no pearl: within the outline about .*, lies what is around it, as in a ring$/,
    () => "真珠が見つかりません。輪郭の中に見えるのは周りと同じもので、輪のようです。",
  ],
  [
    /^the outline cannot be followed: .* an edge is seen on it in (\S+) % of all directions, with a gap of (\S+) degrees;/,
    ([, n, gap]) =>
      `輪郭をたどれません。縁が見えるのは全方向の${n} %で、${gap}°の切れ目があります。`,
  ],
  [
    /^more than one pearl: at \((.+?)\), radius (\S+), and at \((.+?)\), radius (\S+)$/,
    ([, one, r, other, q]) =>
      `真珠が二つ以上あります：(${one})に半径${r}画素、(${other})に半径${q}画素。`,
  ],
  [
    /^the pearl's circle, centre (\(.+?\)), radius (\S+), leaves the picture of (\d+) x (\d+) pixels;/,
    ([, at, r, w, h]) =>
      `真珠の円（中心${at}、半径${r}画素）が${w} × ${h}画素の画像からはみ出しています。全体が入る、半径12画素以上の真珠が必要です。`,
  ],
];

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
