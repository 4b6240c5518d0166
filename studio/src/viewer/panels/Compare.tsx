/** Two sides, a row of variants, and what goes into a study. */

import { useState } from "preact/hooks";
import type { Specs } from "../specs/spec";
import { saveAs } from "../state/files";
import { ESSENTIALS, PEARL_GROUPS, declaration } from "../state/groups";
import { valueAt, withValue } from "../state/path";
import { scaleOf, short } from "../state/scale";
import { active, board, compare, compareNoMore, edit, notice, specs } from "../state/store";
import { studyOf } from "../state/study";
import { choose, chosen, leaveOut } from "../state/tray";
import { wiping } from "../state/view";
import { PEARL_NAMES } from "../words/presets";
import { language, nameOf, t, unitName } from "../words/speech";
import { SmallPicture } from "./Presets";

export function Compare() {
  return (
    <div class="compare">
      <Sides />
      <Strip />
      <StudyTray />
    </div>
  );
}

function Sides() {
  if (board.value.b === null) {
    return (
      <section>
        <h2>{t("tabCompare")}</h2>
        <button type="button" class="main" onClick={compare}>
          {t("compareStart")}
        </button>
      </section>
    );
  }
  return (
    <section>
      <h2>{t("tabCompare")}</h2>
      <div class="segmented" role="group">
        <button
          type="button"
          aria-pressed={active.value === "a"}
          onClick={() => (active.value = "a")}
        >
          {t("turnsA")}
        </button>
        <button
          type="button"
          aria-pressed={active.value === "b"}
          onClick={() => (active.value = "b")}
        >
          {t("turnsB")}
        </button>
      </div>
      <div class="segmented" role="group">
        <button type="button" aria-pressed={!wiping.value} onClick={() => (wiping.value = false)}>
          {t("besides")}
        </button>
        <button type="button" aria-pressed={wiping.value} onClick={() => (wiping.value = true)}>
          {t("wipe")}
        </button>
      </div>
      <button type="button" class="quiet" onClick={compareNoMore}>
        {t("compareEnd")}
      </button>
    </section>
  );
}

/** Knobs that variants can go along: numbers with two ends. */
function alongs(): string[] {
  const all = [
    ...ESSENTIALS,
    ...PEARL_GROUPS.flatMap((group) => [...group.knobs, ...group.physics]),
  ];
  return all.filter((path) => {
    const one = declaration("pearl", path);
    const isThere = valueAt(specs.value.pearl, path) !== undefined;
    return isThere && one !== undefined && scaleOf(one) !== null;
  });
}

const FIVE = [0, 0.25, 0.5, 0.75, 1];

/** Five pearls that differ in one key: two below, this one, two above; or all over its range. */
function variants(path: string, from: number, to: number): { value: number; specs: Specs }[] {
  const one = declaration("pearl", path);
  return FIVE.map((share) => {
    const raw = from + (to - from) * share;
    const value = one?.isWhole === true ? Math.round(raw) : Number(raw.toPrecision(4));
    return {
      value,
      specs: { ...specs.value, pearl: withValue(specs.value.pearl, path, value) },
    };
  });
}

function Strip() {
  const [path, setPath] = useState("nacre.thickness_noise_nm");
  const all = alongs();
  const along = all.includes(path) ? path : (all[0] ?? path);
  const one = declaration("pearl", along);
  const [made, setMade] = useState<{ path: string; list: ReturnType<typeof variants> } | null>(
    null,
  );
  const show = () => {
    const now = valueAt(specs.value.pearl, along);
    setMade({ path: along, list: variants(along, ...around(one, now)) });
  };
  return (
    <section>
      <h2>{t("strip")}</h2>
      <div class="row">
        <label>
          <span class="sr-only">{t("stripAlong")}</span>
          <select value={along} onChange={(event) => setPath(event.currentTarget.value)}>
            {all.map((key) => (
              <option key={key} value={key}>
                {nameOf(key)}
              </option>
            ))}
          </select>
        </label>
        <button type="button" onClick={show}>
          {t("stripMake")}
        </button>
      </div>
      {made !== null && (
        <ul class="strip">
          {made.list.map(({ value, specs: variant }) => (
            <li key={value}>
              <button
                type="button"
                class="choice"
                aria-label={t("stripTake", {
                  name: nameOf(made.path),
                  value: short(value),
                })}
                onClick={() => edit("pearl", made.path, value)}
              >
                <SmallPicture specs={variant} />
                <span>
                  {short(value)} {unitName(declaration("pearl", made.path)?.unit)}
                </span>
              </button>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}

/** The ends of a row: a share of the whole range on either side, or the range up to twice the value. */
function around(one: ReturnType<typeof declaration>, now: unknown): [number, number] {
  const [least, most] = [one?.least ?? 0, one?.most ?? 1];
  if (typeof now !== "number" || now === 0 || most - least <= 1) {
    return [
      least,
      typeof now === "number" && now > 0 ? most : Math.min(most, least + (most - least)),
    ];
  }
  return [Math.max(least, now * 0.5), Math.min(most, now * 1.5)];
}

function StudyTray() {
  const { a, b } = board.value;
  const add = (one: Specs) =>
    choose(one, PEARL_NAMES[one.pearl.name]?.[language.value] ?? one.pearl.name);
  const send = () => {
    const { toml, leftOut } = studyOf(chosen.value);
    saveAs("study.toml", new Blob([toml], { type: "application/toml" }));
    if (leftOut.length > 0) notice.value = t("studyLeftOut", { names: leftOut.join(", ") });
  };
  const isEnough = chosen.value.length >= 2;
  return (
    <section>
      <h2>{t("study")}</h2>
      <p class="says">{t("studyAbout")}</p>
      <ul class="tray">
        {chosen.value.map((one) => (
          <li key={one.label}>
            <SmallPicture specs={one.specs} />
            <span>{one.label}</span>
            <button
              type="button"
              class="reset"
              aria-label={t("studyLeave", { name: one.label })}
              title={t("studyLeave", { name: one.label })}
              onClick={() => leaveOut(one.label)}
            >
              ×
            </button>
          </li>
        ))}
      </ul>
      <div class="row">
        <button type="button" onClick={() => add(specs.value)}>
          {t("studyAdd")}
        </button>
        {b !== null && (
          <button
            type="button"
            onClick={() => {
              add(a.specs);
              add(b.specs);
            }}
          >
            {t("studyAddBoth")}
          </button>
        )}
        <button type="button" class="main" disabled={!isEnough} onClick={send}>
          {t("studySend")}
        </button>
      </div>
      {!isEnough && chosen.value.length > 0 && <p class="says">{t("studyNeedsTwo")}</p>}
    </section>
  );
}
