/** The grey of all pages: the one around the pictures, so that eyes stay used to it. */

const BLACK = 0;
const WHITE = 255;

/** The relative luminance of a grey of sRGB, 0 to 1 (IEC 61966-2-1). */
function luminance(code: number): number {
  const share = code / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}

/** The contrast of two greys, 1 to 21 (WCAG 2.2). */
export function contrastOf(one: number, other: number): number {
  const lights = [luminance(one), luminance(other)];
  return (Math.max(...lights) + 0.05) / (Math.min(...lights) + 0.05);
}

/** Black or white, whichever reads better on a grey: on any at least 4.55 to 1. */
export function inkOn(code: number): number {
  return contrastOf(BLACK, code) >= contrastOf(WHITE, code) ? BLACK : WHITE;
}

/** Give the pages a study's grey. */
export function paint(code: number): void {
  const { style } = document.documentElement;
  const ink = inkOn(code);
  style.setProperty("--surround", `rgb(${code} ${code} ${code})`);
  style.setProperty("--ink", `rgb(${ink} ${ink} ${ink})`);
  style.colorScheme = ink === WHITE ? "dark" : "light";
}
