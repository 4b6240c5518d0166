/** The instruments: what the film does at a point, and what the picture at rest measures. */

import "./instruments.css";
import { declared } from "../../state/path";
import { faults } from "../../state/store";
import { nameOf, t } from "../../words/speech";
import { Diagrams } from "./Diagrams";
import { MeasuresTable } from "./MeasuresTable";
import { LayersPlot, Point } from "./Point";

export function Instruments() {
  if (faults.value.length > 0) return <NoPearl />;
  return (
    <div class="instruments">
      <Point />
      <LayersPlot />
      <MeasuresTable />
      <Diagrams />
    </div>
  );
}

/** Where no picture can be made there is nothing to read, and nothing to wait for; the picture says why. */
function NoPearl() {
  const names = new Set(faults.value.map((one) => nameOf(declared(one.path))));
  return (
    <div class="instruments">
      <p class="nothing">
        {t("failed")} {t("failedSee", { names: [...names].join(", ") })}
      </p>
    </div>
  );
}
