/** What the words are called that a key can have. */

import type { Language } from "./speech";

export const CHOICES: Readonly<Record<string, Readonly<Record<Language, string>>>> = {
  transport: { en: "through the pearl", ja: "内部を通る光" },
  illuminant: { en: "of 1996", ja: "1996年" },
  auto: { en: "of the lamps", ja: "照明の白" },
  none: { en: "none", ja: "なし" },
  white: { en: "white", ja: "白" },
  cream: { en: "cream", ja: "クリーム" },
  pink: { en: "pink", ja: "ピンク" },
  gold: { en: "gold", ja: "ゴールド" },
  "black-lip": { en: "black-lip", ja: "黒蝶" },
  "dyed-blue": { en: "dyed blue", ja: "青染め" },
  "torrance-sparrow": { en: "bell-shaped", ja: "釣り鐘形" },
  ggx: { en: "long tails (GGX)", ja: "裾が長い（GGX）" },
  aragonite: { en: "aragonite", ja: "アラゴナイト" },
  "aragonite-isotropic-1.53": { en: "aragonite, 1.53 all ways", ja: "アラゴナイト（一様1.53）" },
  chitin: { en: "chitin", ja: "キチン" },
  "silk-fibroin": { en: "silk fibroin", ja: "絹フィブロイン" },
  "protein-1.43": { en: "protein, 1.43", ja: "タンパク質（1.43）" },
  orthographic: { en: "parallel rays", ja: "平行" },
  perspective: { en: "as an eye sees", ja: "遠近" },
  plain: { en: "one colour", ja: "一色" },
  checker: { en: "squares", ja: "市松" },
  cloth: { en: "cloth", ja: "布" },
  constant: { en: "one colour", ja: "一色" },
  gradient: { en: "gradient", ja: "グラデーション" },
  panorama: { en: "panorama", ja: "パノラマ" },
  procedural: { en: "computed", ja: "計算" },
  line: { en: "line", ja: "一直線" },
  neck: { en: "neck", ja: "首の周り" },
  "1931-2": { en: "1931, 2°", ja: "1931年 2°" },
  "1964-10": { en: "1964, 10°", ja: "1964年 10°" },
};

export const UNITS: Readonly<Record<string, Readonly<Record<Language, string>>>> = {
  um: { en: "µm", ja: "µm" },
  degrees: { en: "°", ja: "°" },
  days: { en: "days", ja: "日" },
  "layers a day": { en: "a day", ja: "層/日" },
  columns: { en: "columns", ja: "本" },
  pixels: { en: "px", ja: "px" },
  "per mm": { en: "/mm", ja: "/mm" },
  "cycles per mm": { en: "cycles/mm", ja: "周期/mm" },
};
