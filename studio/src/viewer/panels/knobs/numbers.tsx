/** Controls of numbers. */

import { useRef, useState } from "preact/hooks";
import { STEPS, scaleOf, short } from "../../state/scale";
import { t, unitName } from "../../words/speech";
import type { Control } from "./Knob";

/** A slider, and the number itself to type. */
export function NumberControl({ id, name, describedBy, value, declared, set }: Control) {
  const scale = scaleOf(declared);
  const number = value as number;
  return (
    <div class="number">
      {scale !== null && (
        <input
          type="range"
          min={0}
          max={STEPS}
          step={1}
          aria-label={name}
          aria-describedby={describedBy}
          aria-valuetext={`${short(number)} ${unitName(declared.unit)}`}
          value={Math.round(scale.toShare(number) * STEPS)}
          onInput={(event) => set(scale.fromShare(Number(event.currentTarget.value) / STEPS))}
          onKeyDown={(event) => {
            const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
            if (by === undefined || !declared.isWhole) return;
            event.preventDefault(); // one by one, however long the range is
            const next = number + by;
            if (next >= (declared.least ?? -Infinity) && next <= (declared.most ?? Infinity))
              set(next);
          }}
        />
      )}
      <Typed id={id} value={number} control={{ declared, set, describedBy }} />
      <span class="unit">{unitName(declared.unit)}</span>
    </div>
  );
}

interface TypedGiven {
  readonly id: string;
  readonly value: number;
  readonly label?: string;
  readonly control: Pick<Control, "declared" | "set" | "describedBy">;
}

/** A number that is typed: taken when it is one within its range. */
function Typed({ id, value, label, control: { declared, set, describedBy } }: TypedGiven) {
  const [draft, setDraft] = useState<string | null>(null);
  const shown = useRef("");
  shown.current = short(value);
  const allows = (next: number) =>
    Number.isFinite(next) &&
    next >= (declared.least ?? -Infinity) &&
    next <= (declared.most ?? Infinity) &&
    !(declared.leastExcluded && next === declared.least) &&
    !(declared.mostExcluded && next === declared.most) &&
    (!declared.isWhole || Number.isInteger(next));
  const isWrong = draft !== null && !allows(read(draft));
  return (
    <span class="typed">
      <input
        id={id}
        type="text"
        inputMode="decimal"
        autocomplete="off"
        aria-describedby={describedBy}
        aria-invalid={isWrong}
        {...(label === undefined ? {} : { "aria-label": label })}
        value={draft ?? shown.current}
        onInput={(event) => {
          setDraft(event.currentTarget.value);
          const next = read(event.currentTarget.value);
          if (allows(next)) set(next);
        }}
        onBlur={() => setDraft(null)}
        onKeyDown={(event) => {
          if (event.key === "Enter") setDraft(null);
        }}
      />
      {isWrong && <span class="range">{declared.allowed}</span>}
    </span>
  );
}

function read(text: string): number {
  return text.trim() === "" ? NaN : Number(text.trim().replace("−", "-"));
}

/** A seed: its number says nothing, another is drawn by a click. */
export function SeedControl({ id, name, describedBy, value, declared, set }: Control) {
  return (
    <div class="seed">
      <input
        id={id}
        type="text"
        inputMode="numeric"
        autocomplete="off"
        aria-describedby={describedBy}
        value={String(value)}
        onChange={(event) => {
          const text = event.currentTarget.value.trim();
          const isFit = /^\d{1,19}$/.test(text) && BigInt(text) <= 2n ** 63n - 1n;
          if (!isFit) event.currentTarget.value = String(value);
          else set(Number.isSafeInteger(Number(text)) ? Number(text) : BigInt(text));
        }}
      />
      <button
        type="button"
        class="quiet"
        aria-label={t("newChance", { name })}
        title={t("newChance", { name })}
        onClick={() => set(Math.floor(Math.random() * 1e6))}
      >
        ⚄
      </button>
      <span class="unit">{unitName(declared.unit)}</span>
    </div>
  );
}

/** Three numbers: a place or a direction. */
export function TripleControl({ id, name, describedBy, value, declared, set }: Control) {
  const numbers = value as readonly number[];
  if (numbers.length !== 3) return <output id={id}>{numbers.length}</output>;
  return (
    <div class="triple">
      {["x", "y", "z"].map((axis, i) => (
        <Typed
          key={axis}
          id={i === 0 ? id : `${id}-${axis}`}
          label={`${name} ${axis}`}
          value={numbers[i] ?? 0}
          control={{
            declared,
            describedBy,
            set: (next) => set(numbers.map((one, k) => (k === i ? next : one))),
          }}
        />
      ))}
      <span class="unit">{unitName(declared.unit)}</span>
    </div>
  );
}
