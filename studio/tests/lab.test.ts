import { describe, expect, it } from "vitest";

import type { Progress } from "../src/lab/api";
import type { Desk } from "../src/lab/desk";
import { chart, numeral, ticks } from "../src/lab/views/chart";
import { code } from "../src/lab/views/code";
import { rowOf } from "../src/lab/views/person";
import { scale } from "../src/lab/views/scale";
import { en } from "../src/lab/words/en";
import { ja } from "../src/lab/words/ja";
import { Speech } from "../src/lab/words/speech";

/** Every text by its path. */
function flat(words: object, path = ""): Map<string, string> {
  const found = new Map<string, string>();
  for (const [key, value] of Object.entries(words)) {
    if (typeof value === "string") found.set(path + key, value);
    else flat(value as object, `${path}${key}.`).forEach((text, at) => found.set(at, text));
  }
  return found;
}

const places = (text: string) => [...text.matchAll(/\{\w+\}/g)].map(String).sort();

describe("words", () => {
  it("have the same places in both languages", () => {
    const japanese = flat(ja);
    for (const [path, text] of flat(en)) {
      expect([path, places(japanese.get(path) ?? "")]).toEqual([path, places(text)]);
    }
  });

  it("say every mark of a page and a screen in both languages", () => {
    expect(Object.keys(ja.noticed).sort()).toEqual(Object.keys(en.noticed).sort());
  });

  it("tell durations in the largest unit that is not nothing", () => {
    const speech = new Speech("en");
    expect([0, 59.6, 61, 3599, 3600, 90000].map((s) => speech.duration(s))).toEqual([
      "0 s",
      "1 min 0 s",
      "1 min 1 s",
      "59 min 59 s",
      "1 h",
      "1 d",
    ]);
    expect(new Speech("ja").duration(61)).toBe("1分1秒");
  });

  it("call a moment of a clock that is ahead just now", () => {
    const now = new Date("2026-11-25T12:00:00Z");
    const speech = new Speech("en");
    expect(speech.ago("2026-11-25T12:00:30Z", now)).toBe("just now");
    expect(speech.ago("2026-11-25T11:48:00Z", now)).toBe("12 min ago");
  });
});

describe("a person", () => {
  const row = (excluded: string) => {
    const desk = { speech: new Speech("ja"), kept: { explained: new Set() } } as unknown as Desk;
    const person = { number: 4, groups: {}, answers: 2, trials: 9, flags: [], excluded };
    const made = rowOf(desk, { ...person, last_at: null, seconds: null } as never, false, () => 0);
    return [made.querySelector(".badge")?.textContent, made.querySelectorAll("button").length];
  };

  it("who was excluded may be readmitted, who withdrew may not", () => {
    expect(row("too fast")).toEqual(["除外：too fast", 2]);
    expect(row("withdrew")).toEqual(["本人が取りやめ", 1]);
  });
});

describe("the scale", () => {
  it("is asked for each time, for what is told may be of a moment ago", async () => {
    let answers = 20;
    const told = () => ({ text: {}, stimuli: [], answers, people: 2, level: 0.95, unit: "sigma" });
    const asked = { scale: () => Promise.resolve(told()) };
    const kept = { question: "deeper", simulated: false };
    const desk = {
      speech: new Speech("en"),
      kept,
      study: { questions: [] },
      lab: asked,
    } as unknown as Desk;
    const view = scale(desk);
    await view.update({} as Progress);
    expect(view.node.textContent).toContain("20 answers");
    answers = 21;
    await view.update({} as Progress);
    expect(view.node.textContent).toContain("21 answers");
  });
});

describe("the code of a link", () => {
  /** Which modules are dark, by their place. */
  function modules(text: string) {
    const drawn = code(text, "alt");
    const size = Number(drawn.getAttribute("viewBox")?.split(" ")[2]);
    const path = drawn.querySelector("path")?.getAttribute("d") ?? "";
    const dark = new Set([...path.matchAll(/M(\d+ \d+)h1v1h-1z/g)].map((one) => one[1]));
    return { size, dark };
  }

  it("has its three marks and four modules of quiet around it", () => {
    const { size, dark } = modules("http://127.0.0.1:8000/#" + "a".repeat(43));
    const far = size - 4 - 7;
    for (const [left, top] of [
      [4, 4],
      [far, 4],
      [4, far],
    ] as const) {
      for (let at = 0; at < 7; at += 1) {
        expect(dark.has(`${left + at} ${top}`)).toBe(true);
        expect(dark.has(`${left} ${top + at}`)).toBe(true);
      }
      expect(dark.has(`${left + 1} ${top + 1}`)).toBe(false);
      expect(dark.has(`${left + 3} ${top + 3}`)).toBe(true);
    }
    for (const place of dark) {
      const [x = 0, y = 0] = (place ?? "").split(" ").map(Number);
      expect(Math.min(x, y)).toBeGreaterThanOrEqual(4);
      expect(Math.max(x, y)).toBeLessThan(size - 4);
    }
  });

  it("is another one for another link", () => {
    expect(modules("http://lab/#a").dark).not.toEqual(modules("http://lab/#b").dark);
  });
});

describe("the chart", () => {
  it("has round ticks inside its bounds", () => {
    expect(ticks(-1.3, 1.2, 6)).toEqual([-1, -0.5, 0, 0.5, 1]);
    expect(ticks(0.01, 0.09, 4).map((at) => at.toFixed(2))).toEqual([
      "0.02",
      "0.04",
      "0.06",
      "0.08",
    ]);
  });

  it("writes a true minus, and never minus nothing", () => {
    expect([numeral(-0.5), numeral(-0.001), numeral(1.234)]).toEqual([
      "\u22120.50",
      "0.00",
      "1.23",
    ]);
  });

  const scale = {
    question: "q",
    text: { en: "Which?" },
    simulated: false,
    answers: 10,
    people: 2,
    unit: "z" as const,
    level: 0.95,
    verdict: "describes" as const,
    misfit: null,
    people_differ: false,
    people_told: true,
    stimuli: [
      { label: "<b>", picture: "00", value: 0.5, low: 0.5, high: 0.5 },
      { label: "dull", picture: "11", value: -0.5, low: -0.5, high: -0.5 },
    ],
  };
  const captions = { alt: "alt", axis: "axis", mark: "" };

  it("places the higher one to the right, and labels as they are", () => {
    const drawn = chart(scale, 600, captions);
    const at = [...drawn.querySelectorAll(".place")].map((one) => Number(one.getAttribute("cx")));
    expect(at[0]).toBeGreaterThan(at[1] ?? Infinity);
    expect([...drawn.querySelectorAll(".label")].map((one) => one.textContent)).toEqual([
      "<b>",
      "dull",
    ]);
    expect(drawn.getAttribute("class")).toBe("chart");
  });

  it("is marked where nobody answered", () => {
    const drawn = chart(scale, 600, { ...captions, mark: "SIMULATED" });
    expect(drawn.getAttribute("class")).toBe("chart simulated");
    expect(drawn.querySelector(".mark")?.textContent).toBe("SIMULATED");
  });

  it("has no number that is none, whatever the width", () => {
    const same = scale.stimuli.map((one) => ({ ...one, value: 0, low: 0, high: 0 }));
    for (const width of [100, 340, 3000]) {
      expect(chart({ ...scale, stimuli: same }, width, captions).outerHTML).not.toMatch(
        /NaN|Infinity/,
      );
    }
  });
});
