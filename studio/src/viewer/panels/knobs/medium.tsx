/** The control of a medium: by its name, or by its refractive index. */

import { choiceName } from "../../words/speech";
import type { Control } from "./Knob";
import { NumberControl } from "./numbers";

const NAMES = ["aragonite", "aragonite-isotropic-1.53", "chitin", "silk-fibroin", "protein-1.43"];
const INDEX = "n";
/** Indices that a slider offers; others can be typed. */
const SLIDER = { least: 1, most: 2.5 };

export function MediumControl(control: Control) {
  const { id, describedBy, value, declared, set } = control;
  const names = declared.choices ?? NAMES;
  const isNumber = typeof value === "number";
  const isNamed = typeof value === "string";
  const other = isNumber || isNamed ? null : JSON.stringify(value);
  return (
    <>
      <select
        id={id}
        aria-describedby={describedBy}
        value={isNamed ? value : isNumber ? INDEX : "other"}
        onChange={(event) => {
          const chosen = event.currentTarget.value;
          if (chosen !== "other") set(chosen === INDEX ? 1.53 : chosen);
        }}
      >
        {names.map((name) => (
          <option key={name} value={name}>
            {choiceName(name)}
          </option>
        ))}
        <option value={INDEX}>n = …</option>
        {other !== null && <option value="other">{other}</option>}
      </select>
      {isNumber && (
        <NumberControl
          {...control}
          id={`${id}-n`}
          declared={{ ...declared, unit: "", isWhole: false, ...SLIDER }}
        />
      )}
    </>
  );
}
