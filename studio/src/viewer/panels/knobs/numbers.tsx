/** Controls of numbers. */

import type { Declaration } from "../../specs/spec";
import { STEPS, pressed, scaleOf, short } from "../../state/scale";
import { t, unitName } from "../../words/speech";
import { narrow, numberOf } from "../../state/typed";
import type { Control } from "./Knob";
import { Typed, allowedOf } from "./Typed";

const KEYS: Readonly<Record<string, 1 | -1>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
};

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
            const by = KEYS[event.key];
            if (by === undefined) return;
            event.preventDefault(); // a step of the browser's may be less than the value's last digit
            const next = pressed(number, by, declared);
            if (next !== number) set(next);
          }}
        />
      )}
      <Typed
        id={id}
        describedBy={describedBy}
        inputMode="decimal"
        shown={short(number)}
        read={fitting(declared)}
        set={set}
        allowed={allowedOf(declared)}
      />
      <span class="unit">{unitName(declared.unit)}</span>
    </div>
  );
}

/** The number of a text within a key's range; undefined of any other. */
export function fitting(declared: Declaration): (text: string) => number | undefined {
  return (text) => {
    const next = numberOf(text);
    const isFit =
      Number.isFinite(next) &&
      next >= (declared.least ?? -Infinity) &&
      next <= (declared.most ?? Infinity) &&
      !(declared.leastExcluded && next === declared.least) &&
      !(declared.mostExcluded && next === declared.most) &&
      (!declared.isWhole || Number.isInteger(next));
    return isFit ? next : undefined;
  };
}

/** A seed: its number says nothing, another is drawn by a click. */
export function SeedControl({ id, name, describedBy, value, declared, set }: Control) {
  return (
    <div class="seed">
      <Typed
        id={id}
        describedBy={describedBy}
        inputMode="numeric"
        shown={String(value)}
        read={seedOf}
        set={set}
        allowed={allowedOf(declared)}
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

/** A whole number of 63 bits. */
function seedOf(text: string): number | bigint | undefined {
  const plain = narrow(text);
  if (!/^\d{1,19}$/.test(plain) || BigInt(plain) > 2n ** 63n - 1n) return undefined;
  return Number.isSafeInteger(Number(plain)) ? Number(plain) : BigInt(plain);
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
          describedBy={describedBy}
          inputMode="decimal"
          shown={short(numbers[i] ?? 0)}
          read={fitting(declared)}
          set={(next) => set(numbers.map((one, k) => (k === i ? next : one)))}
          allowed={allowedOf(declared)}
        />
      ))}
      <span class="unit">{unitName(declared.unit)}</span>
    </div>
  );
}
