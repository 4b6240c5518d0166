/** The control of a medium: by its name, or by its refractive indices. */

import { choiceName, nameOf } from "../../words/speech";
import type { Control } from "./Knob";
import { NumberControl } from "./numbers";

/** How a medium is given, beside its name. */
const FORMS = {
  n: { label: "n = …", start: 1.53 },
  nk: { label: "n + ik = …", start: [1.53, 0] },
  uniaxial: { label: "nₒ, nₑ = …", start: { n_o: 1.68, n_e: 1.53 } },
} as const;

type Form = keyof typeof FORMS;

/** Indices that a slider offers; a file may have others. */
const INDEX = { least: 1, most: 2.5 };
const ABSORPTION = { least: 0, most: 0.5 };

function formOf(value: unknown): Form | null {
  if (typeof value === "string") return null;
  if (typeof value === "number") return "n";
  return Array.isArray(value) ? "nk" : "uniaxial";
}

export function MediumControl(control: Control) {
  const { id, describedBy, value, declared, set } = control;
  const form = formOf(value);
  return (
    <>
      <select
        id={id}
        aria-describedby={describedBy}
        value={form ?? String(value)}
        onChange={(event) => {
          const chosen = event.currentTarget.value;
          set(chosen in FORMS ? FORMS[chosen as Form].start : chosen);
        }}
      >
        {(declared.choices ?? []).map((name) => (
          <option key={name} value={name}>
            {choiceName(name)}
          </option>
        ))}
        {Object.entries(FORMS).map(([name, { label }]) => (
          <option key={name} value={name}>
            {label}
          </option>
        ))}
      </select>
      <Indices {...control} />
    </>
  );
}

function Indices(control: Control) {
  const { value, id, set, declared } = control;
  const index = (
    name: string,
    number: number,
    range: typeof INDEX,
    to: (next: number) => unknown,
  ) => (
    <div class="index">
      <label for={`${id}-${name}`}>{nameOf(`${declared.path}.${name}`)}</label>
      <NumberControl
        {...control}
        id={`${id}-${name}`}
        name={nameOf(`${declared.path}.${name}`)}
        value={number}
        set={(next) => set(to(next as number))}
        declared={{
          ...declared,
          ...range,
          unit: "",
          isWhole: false,
          allowed: `${range.least} to ${range.most}`,
        }}
      />
    </div>
  );
  if (typeof value === "number") return index("n", value, INDEX, (n) => n);
  if (Array.isArray(value)) {
    const [n, k] = value as [number, number];
    return (
      <>
        {index("n", n, INDEX, (next) => [next, k])}
        {index("k", k, ABSORPTION, (next) => [n, next])}
      </>
    );
  }
  if (typeof value !== "object" || value === null) return null;
  const { n_o, n_e } = value as { n_o: number; n_e: number };
  return (
    <>
      {index("n_o", n_o, INDEX, (next) => ({ n_o: next, n_e }))}
      {index("n_e", n_e, INDEX, (next) => ({ n_o, n_e: next }))}
    </>
  );
}
