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

/** Lights that are offered; any other illuminant or temperature can be typed. */
const LIGHTS = [
  "D65",
  "D50",
  "D55",
  "A",
  "C",
  "E",
  "FL2",
  "FL11",
  "LED-B3",
  "LED-V1",
  "5500K",
  "3000K",
];

export function TextControl({ id, describedBy, value, declared, set }: Control) {
  const isLight = /spectrum$|white$/.test(declared.path);
  return (
    <>
      <input
        id={id}
        type="text"
        class="wide"
        autocomplete="off"
        maxLength={120}
        aria-describedby={describedBy}
        value={String(value)}
        {...(isLight ? { list: `${id}-list` } : {})}
        onChange={(event) => {
          const text = event.currentTarget.value.trim();
          if (text !== "") set(text);
        }}
      />
      {isLight && (
        <datalist id={`${id}-list`}>
          {(declared.path.endsWith("white") ? ["auto", ...LIGHTS] : LIGHTS).map((light) => (
            <option key={light} value={light} />
          ))}
        </datalist>
      )}
    </>
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
