/** Two sides, a row of variants, and what goes into a study. */

import { useState } from "preact/hooks";
import type { Specs } from "../specs/spec";
import { saveAs } from "../state/files";
import { ESSENTIALS, PEARL_GROUPS, declaration } from "../state/groups";
import { changes, declared, valueAt, withValue } from "../state/path";
import { scaleOf, short } from "../state/scale";
import {
  type Side,
  type Which,
  active,
  board,
  compare,
  compareNoMore,
  edit,
  notice,
  specs,
  together,
} from "../state/store";
import { studyOf } from "../state/study";
import { choose, chosen, leaveOut } from "../state/tray";
import { wiping } from "../state/view";
import { PEARL_NAMES } from "../words/presets";
import { language, nameOf, t, unitName } from "../words/speech";
import { focusNext } from "./focus";
import { Difference } from "./Difference";
import { Typed, allowedOf } from "./knobs/Typed";
import { fitting } from "./knobs/numbers";
import { SmallPicture } from "./Presets";

export function Compare() {
  return (
    <div class="compare">
      <Sides />
      {board.value.b !== null && <Difference />}
      <Strip />
      <StudyTray />
    </div>
  );
}

/** Which side the knobs turn. */
export function SideSwitch() {
  const one = (which: Which, word: "turnsA" | "turnsB") => (
    <button
      type="button"
      aria-pressed={active.value === which}
      onClick={() => (active.value = which)}
    >
      {t(word)}
    </button>
  );
  return (
    <div class="segmented" role="group" aria-label={t("tabCompare")}>
      {one("a", "turnsA")}
      {one("b", "turnsB")}
    </div>
  );
}

/** Begins to compare, and says which side is the copy. */
export function beginComparing(): void {
  compare();
  notice.value = t("compareBegun");
  focusNext(".panel .segmented [aria-pressed=true]");
}

function endComparing(): void {
  compareNoMore();
  focusNext(".compare .main");
}

function Sides() {
  if (board.value.b === null) {
    return (
      <section>
        <h2>{t("tabCompare")}</h2>
        <button type="button" class="main" onClick={beginComparing}>
          {t("compareStart")}
        </button>
      </section>
    );
  }
  return (
    <section>
      <h2>{t("tabCompare")}</h2>
      <SideSwitch />
      <div class="segmented" role="group">
        <button type="button" aria-pressed={!wiping.value} onClick={() => (wiping.value = false)}>
          {t("besides")}
        </button>
        <button type="button" aria-pressed={wiping.value} onClick={() => (wiping.value = true)}>
          {t("wipe")}
        </button>
      </div>
      <label class="check">
        <input
          type="checkbox"
          checked={together.value}
          onChange={(event) => (together.value = event.currentTarget.checked)}
        />
        {t("together")}
      </label>
      <button type="button" onClick={endComparing}>
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

interface Variant {
  readonly value: number;
  readonly specs: Specs;
}

/** Five pearls that differ in one key, evenly from one end to the other. */
function variants(path: string, [from, to]: Ends): Variant[] {
  const isWhole = declaration("pearl", path)?.isWhole === true;
  const values = FIVE.map((share) => {
    const value = from + (to - from) * share;
    return isWhole ? Math.round(value) : Number(value.toPrecision(3));
  });
  return [...new Set(values)].map((value) => ({
    value,
    specs: { ...specs.value, pearl: withValue(specs.value.pearl, path, value) },
  }));
}

type Ends = readonly [from: number, to: number];

/** From a fourth of the value to twice of it; all of a range that is a share. */
function endsOf(path: string): Ends {
  const one = declaration("pearl", path);
  const [least, most] = [one?.least ?? 0, one?.most ?? 1];
  const now = valueAt(specs.value.pearl, path);
  if (typeof now !== "number" || now <= 0 || most - least <= 1) return [least, most];
  return [Math.max(least, now / 4), Math.min(most, now * 2)];
}

function Strip() {
  const [path, setPath] = useState("nacre.thickness_noise_nm");
  const all = alongs();
  const along = all.includes(path) ? path : (all[0] ?? path);
  const [typed, setTyped] = useState<Ends | null>(null);
  const [made, setMade] = useState<{ path: string; list: Variant[] } | null>(null);
  const ends = typed ?? endsOf(along);
  const one = declaration("pearl", along);
  const end = (which: 0 | 1) => (
    <Typed
      label={t(which === 0 ? "stripFrom" : "stripTo")}
      inputMode="decimal"
      shown={short(ends[which])}
      read={one === undefined ? () => undefined : fitting(one)}
      set={(value) => setTyped(which === 0 ? [value, ends[1]] : [ends[0], value])}
      allowed={one === undefined ? "" : allowedOf(one)}
    />
  );
  return (
    <section>
      <h2>{t("strip")}</h2>
      <div class="row">
        <label>
          <span class="sr-only">{t("stripAlong")}</span>
          <select
            value={along}
            onChange={(event) => {
              setPath(event.currentTarget.value);
              setTyped(null);
            }}
          >
            {all.map((key) => (
              <option key={key} value={key}>
                {nameOf(key)}
              </option>
            ))}
          </select>
        </label>
        <button type="button" onClick={() => setMade({ path: along, list: variants(along, ends) })}>
          {t("stripMake")}
        </button>
      </div>
      <div class="ends">
        {end(0)} – {end(1)} {unitName(one?.unit)}
      </div>
      {made !== null && <Variants path={made.path} list={made.list} />}
    </section>
  );
}

function Variants({ path, list }: { path: string; list: readonly Variant[] }) {
  const unit = unitName(declaration("pearl", path)?.unit);
  return (
    <ul class="strip">
      {list.map(({ value, specs: variant }, at) => (
        <li key={at}>
          <button
            type="button"
            class="choice"
            aria-label={t("stripTake", { name: nameOf(path), value: short(value) })}
            aria-pressed={valueAt(specs.value.pearl, path) === value}
            onClick={() => edit("pearl", path, value)}
          >
            <SmallPicture specs={variant} />
            <span>
              {short(value)} {unit}
            </span>
          </button>
        </li>
      ))}
    </ul>
  );
}

/** A pearl's name, and what was turned of it, as far as that is short. */
function labelOf({ specs: now, origin }: Side): string {
  const name = PEARL_NAMES[now.pearl.name]?.[language.value] ?? now.pearl.name;
  const turned = changes(origin.pearl, now.pearl).map(({ path, to }) => {
    const unit = unitName(declaration("pearl", path)?.unit);
    const value = typeof to === "number" ? short(to) : String(to);
    return `${nameOf(declared(path))} ${value} ${unit}`.trim();
  });
  return [name, ...turned.slice(0, 2)].join(", ").slice(0, 100);
}

interface AddGiven {
  readonly word: "studyAdd" | "studyAddA" | "studyAddB" | "studyAddBoth";
  readonly sides: readonly Side[];
}

function Add({ word, sides }: AddGiven) {
  const add = () => sides.forEach((one) => choose(one.specs, labelOf(one)));
  return (
    <button type="button" onClick={add}>
      {t(word)}
    </button>
  );
}

/** A study compares two pearls or more. */
const LEAST_CHOSEN = 2;

function StudyTray() {
  const { a, b } = board.value;
  const send = () => {
    const { toml, leftOut } = studyOf(chosen.value);
    saveAs("study.toml", new Blob([toml], { type: "application/toml" }));
    if (leftOut.length > 0) notice.value = t("studyLeftOut", { names: leftOut.join(", ") });
  };
  const count = chosen.value.length;
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
        {b === null ? (
          <Add word="studyAdd" sides={[a]} />
        ) : (
          <>
            <Add word="studyAddA" sides={[a]} />
            <Add word="studyAddB" sides={[b]} />
            <Add word="studyAddBoth" sides={[a, b]} />
          </>
        )}
      </div>
      <p class="says" id="study-count" role="status">
        {count >= LEAST_CHOSEN
          ? t("studyChosen", { n: count })
          : t("studyNeedsMore", { n: count, m: LEAST_CHOSEN - count })}
      </p>
      <button
        type="button"
        class="main"
        disabled={count < LEAST_CHOSEN}
        aria-describedby="study-count"
        onClick={send}
      >
        {t("studySend")}
      </button>
    </section>
  );
}
