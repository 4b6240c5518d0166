/** A knob: a key's name, its value, what the trade says, and one plain sentence. */

import { useId } from "preact/hooks";
import type { Declaration, Kind } from "../../specs/spec";
import { declaration } from "../../state/groups";
import { declared, valueAt } from "../../state/path";
import { short } from "../../state/scale";
import { edit, faults, originAt, resolved, specs } from "../../state/store";
import { wordFor } from "../../state/trade";
import { knobSays } from "../../words/complaints";
import { language, nameOf, saysOf, t, unitName } from "../../words/speech";
import { focusNext } from "../focus";
import { Said } from "../Said";
import { ColourControl, LightControl, SelectControl, TextControl, Told } from "./choices";
import { DateControl } from "./dates";
import { NumberControl, SeedControl, TripleControl } from "./numbers";
import { MediumControl } from "./medium";

export interface Control {
  readonly id: string;
  readonly name: string;
  readonly describedBy: string;
  readonly value: unknown;
  readonly declared: Declaration;
  readonly set: (value: unknown) => void;
}

const DATES = ["nacre.harvest", "nacre.seeding", "nacre.peak"];
const MEDIA = ["nacre.aragonite", "nacre.protein"];
const LIT = /spectrum$|white$/;
const TOLD = [
  "model",
  "nacre.preset",
  "nacre.thickness_nm",
  "rows.pearls",
  "sky.path",
  "texture.source",
];

const same = (a: unknown, b: unknown) => a === b || String(a) === String(b);

export function Knob({ kind, path }: { kind: Kind; path: string }) {
  const id = useId();
  const one = declaration(kind, path);
  const value = valueAt(specs.value[kind], path);
  if (one === undefined || value === undefined) return null;
  const key = declared(path);
  const name = nameOf(key);
  const origin = originAt(kind, path);
  const wrong = faults.value.filter((one) => one.kind === kind && one.path === path);
  const set = (next: unknown) => edit(kind, path, next);
  const control = { id, name, describedBy: `${id}-says`, value, declared: one, set };
  return (
    <div class={wrong.length > 0 ? "knob wrong" : "knob"} data-key={path}>
      <div class="head">
        <label for={id}>{name}</label>
        <TradeWord path={key} value={value} />
        {!same(value, origin) && origin !== undefined && (
          <button
            type="button"
            class="reset"
            aria-label={t("resetKey", { name })}
            title={t("resetKey", { name })}
            onClick={() => {
              set(origin);
              focusNext(`[data-key="${path}"] :is(input, select, button)`);
            }}
          >
            ↺
          </button>
        )}
      </div>
      {value === null ? <Open {...control} path={path} /> : <Set {...control} path={key} />}
      <p class="says" id={`${id}-says`}>
        {saysOf(key)}
        {value !== null && one.isOpen && origin === null && (
          <button type="button" class="link" onClick={() => set(null)}>
            {t("openNow")}
          </button>
        )}
      </p>
      {wrong.map((complaint) => (
        <p class="complaint" role="alert" key={complaint.text}>
          <Said {...knobSays(complaint)} />
        </p>
      ))}
    </div>
  );
}

/** A key whose value the renderer finds. */
function Open({ id, declared: one, set, path, describedBy }: Control & { path: string }) {
  const found = resolved.value[path];
  const value =
    found === undefined
      ? null
      : `${short(Number(found.toPrecision(3)))} ${unitName(one.unit)}`.trim();
  const start = found ?? (one.isWhole ? (one.least ?? 0) : middle(one));
  return (
    <div class="open">
      <span>{value === null ? t("openKey") : t("openWith", { value })}</span>
      {one.least !== null && (
        <button
          type="button"
          class="link"
          id={id}
          aria-describedby={describedBy}
          onClick={() => set(start)}
        >
          {t("setNow")}
        </button>
      )}
    </div>
  );
}

/** Somewhere to begin where nothing is known: near the lower end of long ranges. */
function middle({ least, most }: Declaration): number {
  const [low, high] = [least ?? 0, most ?? 1];
  const start = low > 0 && high / low > 100 ? Math.sqrt(low * high) : (low + high) / 2;
  return Number(start.toPrecision(2));
}

function Set(control: Control & { path: string }) {
  const { path, value, declared: one } = control;
  if (TOLD.includes(path)) return <Told {...control} />;
  if (DATES.includes(path)) return <DateControl {...control} />;
  if (MEDIA.includes(path)) return <MediumControl {...control} />;
  if (LIT.test(path)) return <LightControl {...control} />;
  if (one.choices !== undefined) return <SelectControl {...control} />;
  if (typeof value === "bigint" || (one.isWhole && (one.most ?? 0) > 1e7)) {
    return <SeedControl {...control} />;
  }
  if (typeof value === "number") return <NumberControl {...control} />;
  if (Array.isArray(value)) return <TripleControl {...control} />;
  if (typeof value === "string" && value.startsWith("#")) return <ColourControl {...control} />;
  return <TextControl {...control} />;
}

function TradeWord({ path, value }: { path: string; value: unknown }) {
  const number = value === null ? resolved.value[path] : value;
  if (typeof number !== "number") return null;
  const word = wordFor(path, number, specs.value.pearl.name, language.value);
  return word === null ? null : (
    <span class="word" title={t("wordOf")}>
      {word}
    </span>
  );
}
