/** Controls of what is chosen or typed as text. */

import { choiceName } from "../../words/speech";
import type { Control } from "./Knob";

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

export function ColourControl({ id, name, describedBy, value, set }: Control) {
  return (
    <div class="colour">
      <input
        type="color"
        aria-label={name}
        value={String(value).toLowerCase()}
        onInput={(event) => set(event.currentTarget.value)}
      />
      <input
        id={id}
        type="text"
        autocomplete="off"
        aria-describedby={describedBy}
        value={String(value)}
        onChange={(event) => {
          const text = event.currentTarget.value.trim();
          if (/^#[0-9a-f]{6}$/i.test(text)) set(text);
          else event.currentTarget.value = String(value);
        }}
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

export function TextControl({ id, describedBy, value, set }: Control) {
  return (
    <input
      id={id}
      type="text"
      class="wide"
      autocomplete="off"
      maxLength={120}
      aria-describedby={describedBy}
      value={String(value)}
      onChange={(event) => {
        const text = event.currentTarget.value.trim();
        if (text !== "") set(text);
      }}
    />
  );
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
