/** What the presets are called. */

import type { Language } from "./speech";

type Names = Readonly<Record<string, Readonly<Record<Language, string>>>>;

export const PEARL_NAMES: Names = {
  "akoya-rg": { en: "Akoya, blue-green", ja: "アコヤ 青緑" },
  "akoya-r": { en: "Akoya, red", ja: "アコヤ 赤" },
  "akoya-g": { en: "Akoya, green", ja: "アコヤ 緑" },
  "akoya-pink": { en: "Akoya, pink", ja: "アコヤ ピンク" },
  "akoya-cream": { en: "Akoya, cream", ja: "アコヤ クリーム" },
  "akoya-dyed-blue": { en: "Akoya, dyed blue", ja: "アコヤ 青染め" },
  "akoya-thin": { en: "Akoya, thin nacre", ja: "アコヤ 薄巻き" },
  "south-sea-white": { en: "South Sea, white", ja: "南洋 白" },
  "south-sea-gold": { en: "South Sea, gold", ja: "南洋 ゴールド" },
  tahitian: { en: "Tahitian", ja: "黒蝶" },
  paper: { en: "Akoya, winter harvest (1996)", ja: "アコヤ 冬揚げ（1996年）" },
  "paper-green": { en: "Of 1996, green", ja: "1996年 緑" },
  "paper-summer-harvest": { en: "Akoya, summer harvest (1996)", ja: "アコヤ 夏揚げ（1996年）" },
  ...masters("r", "red", "赤"),
  ...masters("rg", "blue-green", "青緑"),
  ...masters("g", "green", "緑"),
};

/** The steps of a family's masters, and the one of reported thickness. */
function masters(family: string, en: string, ja: string): Names {
  const made: Record<string, Record<Language, string>> = {};
  const steps = [
    ["0.0", "none", "なし"],
    ["0.4", "slight", "わずか"],
    ["0.7", "clear", "明瞭"],
    ["1.0", "vivid", "鮮やか"],
    ["published", "as reported", "報告値"],
  ] as const;
  for (const [step, said, told] of steps) {
    made[`akoya-${family}-${step}`] = {
      en: `Master, ${en}, ${said}`,
      ja: `マスター ${ja} ${told}`,
    };
  }
  return made;
}

export const SCENE_NAMES: Names = {
  "north-window-black": { en: "Black cloth", ja: "黒い布" },
  "north-window-white": { en: "White cloth", ja: "白い布" },
  aurora: { en: "Aurora viewer", ja: "オーロラ\u200bビューア" },
  booth: { en: "Light booth", ja: "観察ブース" },
  paper: { en: "Lamp and squares", ja: "照明と市松" },
  "two-tier": { en: "Sorting tray", ja: "選別台" },
};
