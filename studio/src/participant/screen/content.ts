/** What is found out about a screen; kept with the answers as it is. */

import type { Monitor, Plates, ScreenCheck, Vision, Window } from "../../shared/wire";

export type Share = Plates;

type Known<T> = { [K in keyof T]-?: NonNullable<T[K]> };

/** A screen check in which nothing is forgotten: null is said of what was not measured. */
export type ScreenContent = Required<ScreenCheck> & {
  window: Known<Window>;
  screen: Known<Monitor>;
  vision: Vision;
};

/** What the browser itself tells: window, screen, colours. */
export function told(): ScreenContent {
  return {
    window: {
      width_px: window.innerWidth,
      height_px: window.innerHeight,
      device_pixel_ratio: window.devicePixelRatio,
    },
    full_screen: document.fullscreenElement !== null,
    screen: {
      width_px: screen.width,
      height_px: screen.height,
      colour_depth: screen.colorDepth,
    },
    card: null,
    picture_width_mm: null,
    distance_mm: null,
    distance_by: "none",
    distance_tries_mm: [],
    gamma: null,
    darkest_step: null,
    gamut: gamut(),
    hdr: matchMedia("(dynamic-range: high)").matches,
    vision: {},
    agent: agent(navigator.userAgent),
    simulated: false,
  };
}

function gamut(): ScreenContent["gamut"] {
  for (const name of ["rec2020", "p3", "srgb"] as const) {
    if (matchMedia(`(color-gamut: ${name})`).matches) return name;
  }
  return "less";
}

/** The browser's family and version, and nothing else of what it tells about itself. */
export function agent(told: string): string {
  const families = [
    ["Edge", /Edg\w*\/(\d+)/],
    ["Opera", /OPR\/(\d+)/],
    ["Samsung Internet", /SamsungBrowser\/(\d+)/],
    ["Firefox", /(?:Firefox|FxiOS)\/(\d+)/],
    ["Chromium", /(?:Chrome|Chromium|CriOS)\/(\d+)/],
    ["Safari", /Version\/(\d+)[.\d]* .*Safari/],
  ] as const;
  for (const [name, pattern] of families) {
    const found = pattern.exec(told);
    if (found) return `${name} ${found[1]}`;
  }
  return "another browser";
}
