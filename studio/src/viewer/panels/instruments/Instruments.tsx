/** The instruments: what the film does at a point, and what the picture at rest measures. */

import "./instruments.css";
import { faults } from "../../state/store";
import { knobSays } from "../../words/complaints";
import { t } from "../../words/speech";
import { Said } from "../Said";
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

/** Where no picture can be made there is nothing to read, and nothing to wait for. */
function NoPearl() {
  return (
    <div class="instruments">
      <section class="instrument">
        <p class="nothing">{t("failed")}</p>
        {faults.value.map((one) => (
          <p class="nothing" key={one.text}>
            <Said {...knobSays(one)} />
          </p>
        ))}
      </section>
    </div>
  );
}
