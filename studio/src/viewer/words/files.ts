/** What the page says about files that are opened and saved, and of how far apart two pictures look. */

import { fill } from "../../shared/language";
import { language } from "./speech";

const EN = {
  tookLight: "All lamps and windows shine with {name}.",
  noLight: "{name} is there; this scene has no lamp or window that could shine with it.",
  tookPanorama: "{name} is the sky around the pearl.",
  tookGrain: "{name} was taken as a photograph of grain: the pearl has its grain now.",
  tookRecipe: "This is the picture's pearl, {name}, in its scene.",
  reading: "Reading {name} …",
  saving: "The picture is being made with its layers …",
  saveExr: "Picture with layers (EXR)",
  linkWithout:
    "The link is copied without {names}: whoever opens it needs to drop that here first.",
  linkOfSide: " It holds {side} alone, and not {other}.",
  layer: "Layer",
  whole: "The picture",
  interference: "Interference",
  diffuse: "From inside",
  mirror: "Mirrored",
  surroundings: "Surroundings",
  texture: "Grain: hue, value, chroma",
  coverage: "Coverage",
  shadow: "Shadow",
  probe: "The layer. Arrow keys move the probe; with Shift by ten pixels.",
  probeHint: "Point at the picture, or use the arrow keys.",
  column: "Column",
  row: "Row",
  linear: "Linear",
  code: "Code",
  takeRecipe: "Take its pearl and scene",
  takeGrain: "Take it as a photograph of grain",
  holdsRecipe: "It holds what it was made from: {pearl}, in {scene}.",
  noRecipe: "What it was made from cannot be used:",
  andSo: "and {n} more",
  close: "Close",
  difference: "How far apart they look",
  differenceAbout: "CIEDE2000 between A and B. About 1 can just be seen.",
  differenceWaits: "As soon as both pictures are finished.",
  mean: "Mean",
  percentile: "95 of 100 pixels up to",
  largest: "Largest",
  overPearl: "over the {n} pixels of the pearl",
  noPearl: "No pixel belongs to a pearl in both.",
  andMore: "{most} and more",
  coloursEnd: "The colours end at {most}; the largest difference here is {largest}.",
  differenceMap: "Map of the differences: from dark, none, to yellow, {most} and more.",
} as const;

export type FileWord = keyof typeof EN;

const JA: Record<FileWord, string> = {
  tookLight: "すべてのランプと窓が {name} の光になりました。",
  noLight: "{name} を読み込みました。この場面には、その光にするランプも窓もありません。",
  tookPanorama: "{name} を真珠のまわりの空にしました。",
  tookGrain: "{name} をきめの写真として使い、真珠のきめをそこからとりました。",
  tookRecipe: "画像のもとの真珠 {name} とその場面です。",
  reading: "{name} を読み込んでいます…",
  saving: "レイヤーつきの画像をつくっています…",
  saveExr: "レイヤーつきの画像（EXR）",
  linkWithout:
    "リンクをコピーしました。{names} は入っていません。開く人は、先にそのファイルをここへ入れてください。",
  linkOfSide: "比べている二つのうち、入るのは{side}だけで、{other}は入りません。",
  layer: "レイヤー",
  whole: "画像",
  interference: "干渉光",
  diffuse: "内部からの光",
  mirror: "映り込み",
  surroundings: "まわり",
  texture: "キメ：色相・明度・彩度",
  coverage: "真珠の占める割合",
  shadow: "影",
  probe: "レイヤー。矢印キーで位置を動かし、Shiftを押しながらだと10画素ずつ動きます。",
  probeHint: "画像を指すか、矢印キーを使ってください。",
  column: "列",
  row: "行",
  linear: "線形値",
  code: "コード",
  takeRecipe: "真珠と場面を取り出す",
  takeGrain: "キメの写真として使う",
  holdsRecipe: "もとの真珠と場面が入っています：{pearl}、{scene}",
  noRecipe: "もとの真珠と場面は使えません：",
  andSo: "ほか{n}件",
  close: "閉じる",
  difference: "見た目の違い",
  differenceAbout: "AとBのCIEDE2000色差。1くらいから見分けられます。",
  differenceWaits: "両方の画像ができあがると表示されます。",
  mean: "平均",
  percentile: "95%の画素はこの値まで",
  largest: "最大",
  overPearl: "真珠の{n}画素について",
  noPearl: "両方で真珠にあたる画素がありません。",
  andMore: "{most}以上",
  coloursEnd: "色は{most}で終わりです。ここでの最大は{largest}です。",
  differenceMap: "色差の地図。暗いところは差がなく、黄色は{most}以上です。",
};

export function fileWord(word: FileWord, places: Record<string, string | number> = {}): string {
  return fill((language.value === "ja" ? JA : EN)[word], places);
}

/** What a layer of ours is called; others keep their name. */
export function layerName(name: string): string {
  if (name === "") return fileWord("whole");
  return name in EN ? fileWord(name as FileWord) : name;
}
