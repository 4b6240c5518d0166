/** What the instruments are called and say, in both languages. */

import { fill } from "../../shared/language";
import { language } from "./speech";

const WORDS = {
  point: ["At the point", "指した点"],
  pointAbout: [
    "Point at the pearl; click to stay. With the keyboard, move the ring on the picture.",
    "真珠を指してください。押すとその点に留まります。キーボードでは画像上の輪を動かします。",
  ],
  probe: [
    "Point of the instruments, {x} % from the left, {y} % from the top{angle}. Arrow keys move it, with Shift finely; Enter copies its spectra.",
    "計測点：左から{x} %、上から{y} %{angle}。矢印キーで動き、Shiftで細かく動きます。Enterでスペクトルをコピーします。",
  ],
  probeAngle: [", view angle {n}°", "、視角{n}°"],
  viewAngle: ["View angle", "視角"],
  beside: ["There is no pearl at this point.", "この点に真珠はありません。"],
  reflected: ["R, reflected", "R 反射"],
  transmitted: ["T, into the pearl", "T 透過"],
  noFilm: ["There is no film to ask here:", "ここには調べる膜がありません："],
  spectraPlot: [
    "Reflectance and transmittance of the film, in percent, over wavelength, 380 to 780 nm",
    "膜の反射率と透過率（%）、波長380〜780 nm",
  ],
  exact: [
    "Exact optics of the whole film, unpolarised: the mean over its columns, as rendered.",
    "膜全体の厳密な光学計算。無偏光、柱の平均で、画像と同じ値です。",
  ],
  copy: ["Copy numbers", "数値をコピー"],
  copied: ["The numbers are copied.", "数値をコピーしました。"],
  notCopied: ["The browser does not let this page copy.", "ブラウザーがコピーを許可していません。"],
  copyOne: ["Copy {name}, {value}", "{name}、{value}をコピー"],
  layers: ["Layers and days", "層と日付"],
  layersAbout: [
    "The surface is on the left; lighter ground is summer; a line marks where the film ends.",
    "左が表面、明るい地が夏、縦線が膜の終わりです。",
  ],
  layersPlot: [
    "Thickness of each aragonite layer in nm, over depth in µm",
    "アラゴナイト層の厚さ（nm）、深さ（µm）",
  ],
  layersListed: [
    "These layers are listed; they have no days.",
    "列挙された層で、日付はありません。",
  ],
  depth: ["Depth", "深さ"],
  thickness: ["Thickness", "厚さ"],
  grewOn: ["Grew on", "成長日"],
  filmAlone: ["Film alone", "膜だけ"],
  allNacre: ["All nacre", "真珠層全体"],
  count: ["{n} layers, {least} to {most} nm", "{n}層、{least}〜{most} nm"],
  measures: ["Measures", "測定値"],
  measuresAbout: [
    "Of the picture at rest, with standard errors, as nacreous measure has them.",
    "仕上がった画像の測定値と標準誤差。nacreous measureと同じです。",
  ],
  drawn: ["Draw what was found over the picture", "見つけたものを画像に描く"],
  measuring: ["Measuring when the picture is finished …", "画像が仕上がると測ります…"],
  refused: ["Not measured", "測れないもの"],
  shape: ["Size and shape", "大きさと形"],
  colour: ["Colour of the whole", "全体の色"],
  overtone: ["Interference", "干渉色"],
  lamp: ["The lamp's image", "照明の映り込み"],
  blemishes: ["Blemishes", "キズ"],
  rings: ["Rings", "同心環"],
  roundness: ["Roundness", "真円度"],
  diameter: ["Diameter", "直径"],
  least: ["Least", "最小"],
  greatest: ["Greatest", "最大"],
  lightness: ["Lightness L*", "明度 L*"],
  chroma: ["Chroma C*", "彩度 C*"],
  hue: ["Hue angle", "色相角"],
  meanChroma: ["Mean chroma", "平均彩度"],
  orient: ["Orient, spread of colour", "色の広がり"],
  score: ["Saturated area", "彩度の高い面積"],
  red: ["red", "赤"],
  yellow: ["yellow", "黄"],
  green: ["green", "緑"],
  blueGreen: ["blue-green", "青緑"],
  blue: ["blue", "青"],
  purple: ["purple", "紫"],
  lampAngle: ["Off the middle", "中心からの角"],
  peak: ["Peak, white = 1", "最大輝度（白＝1）"],
  around: ["Around it, white = 1", "周囲の輝度（白＝1）"],
  halfWidth: ["Half-width", "半値半幅"],
  gloss: ["Contrast gloss", "対比光沢度"],
  haze: ["Haze", "ヘイズ"],
  distinctness: ["Distinctness", "写像性"],
  blemishArea: ["Area", "面積"],
  blemishCount: ["Count", "個数"],
  threshold: ["Least difference told", "見分けられる最小の差"],
  relief: ["Fainter blemishes", "より淡いキズ"],
  hueRings: ["Colour by angle", "角度ごとの色"],
  hueRingsAbout: [
    "Rings from the middle of the pearl to its rim. Left as it is, right with thrice the chroma.",
    "真珠の中心から縁までの環。左は実際の色、右は彩度を3倍にした色。",
  ],
  hueWheel: [
    "Colour of each ring: hue around, chroma outwards, from the pearl's middle (white dot) to its rim",
    "環ごとの色：周りが色相、外へ彩度。白い点が中心、線が縁へ向かいます",
  ],
  chromaOf: ["chroma {n}", "彩度{n}"],
  angle: ["Angle", "角度"],
  profile: ["Profile of the lamp's image", "映り込みの断面"],
  profileAbout: [
    "Luminance from its middle outwards, by the angle of the surface; a line marks half of the peak.",
    "中心から外への輝度。横軸は面の角度、線は最大の半分の位置です。",
  ],
  profilePlot: [
    "Luminance of the lamp's image over degrees from its middle",
    "映り込みの輝度、中心からの角度（度）",
  ],
  luminance: ["Luminance", "輝度"],
  chromaticity: ["CIE 1931 chromaticity", "CIE 1931 色度"],
  chromaticityAbout: [
    "The pearl's pixels, the white, and what screens show: sRGB (solid), P3 (dashed).",
    "真珠の画素と白色点。画面の色域はsRGB（実線）とP3（破線）。",
  ],
  closer: ["Closer", "拡大"],
  whole: ["Whole", "全体"],
} as const satisfies Record<string, readonly [string, string]>;

export type InstrumentWord = keyof typeof WORDS;

/** A word or sentence, its places filled. */
export function say(word: InstrumentWord, places: Record<string, string | number> = {}): string {
  const text: string = WORDS[word][language.value === "ja" ? 1 : 0];
  return fill(text, places);
}
