/** Controls of what is chosen or typed as text. */

import { choiceName } from "../../words/speech";
import { narrow } from "../../state/typed";
import type { Control } from "./Knob";
import { Typed, allowedOf } from "./Typed";

export function SelectControl({ id, describedBy, value, declared, set }: Control) {
  const choices = declared.choices ?? [];
  const all = choices.includes(String(value)) ? choices : [String(value), ...choices];
  return (
    <select
      id={id}
      aria-describedby={describedBy}
      value={String(value)}
      onChange={(event) => set(event.currentTarget.value)}
    >
      {all.map((choice) => (
        <option key={choice} value={choice}>
          {choiceName(choice)}
        </option>
      ))}
    </select>
  );
}

export function ColourControl({ id, name, describedBy, value, declared, set }: Control) {
  return (
    <div class="colour">
      <input
        type="color"
        aria-label={name}
        value={String(value).toLowerCase()}
        onInput={(event) => set(event.currentTarget.value)}
      />
      <Typed
        id={id}
        describedBy={describedBy}
        shown={String(value)}
        read={(text) => (/^#[0-9a-f]{6}$/i.test(narrow(text)) ? narrow(text) : undefined)}
        set={set}
        allowed={allowedOf(declared)}
      />
    </div>
  );
}

/** CIE's illuminants, and colour temperatures; a file may have any other. */
const LIGHTS = [
  ...["D65", "D50", "D55", "D75", "A", "C", "E"],
  ...["2700K", "3000K", "4000K", "5000K", "5500K", "6500K", "10000K"],
  ...Array.from({ length: 12 }, (_, i) => `FL${i + 1}`),
  ...["LED-B1", "LED-B2", "LED-B3", "LED-B4", "LED-B5", "LED-BH1", "LED-RGB1", "LED-V1", "LED-V2"],
];

export function LightControl(control: Control) {
  const choices = control.declared.path.endsWith("white") ? ["auto", ...LIGHTS] : LIGHTS;
  return <SelectControl {...control} declared={{ ...control.declared, choices }} />;
}

export function TextControl({ id, describedBy, value, declared, set }: Control) {
  return (
    <Typed
      id={id}
      describedBy={describedBy}
      class="wide"
      shown={String(value)}
      read={lineOf}
      set={set}
      allowed={allowedOf(declared)}
    />
  );
}

/** What names may have, in letters. */
const MOST_LETTERS = 120;

function lineOf(text: string): string | undefined {
  const line = text.trim();
  const letters = Array.from(line).length;
  return letters > 0 && letters <= MOST_LETTERS ? line : undefined;
}

/** What is told and not turned here. */
export function Told({ id, value }: Control) {
  const text = Array.isArray(value)
    ? value.length > 4
      ? `${value.slice(0, 3).join(", ")} … (${value.length})`
      : value.join(", ")
    : choiceName(String(value));
  return (
    <output id={id} class="told">
      {text}
    </output>
  );
}
