/** The instruments: what the film does at a point, and what the picture at rest measures. */

import "./instruments.css";
import { Diagrams } from "./Diagrams";
import { MeasuresTable } from "./MeasuresTable";
import { LayersPlot, Point } from "./Point";

export function Instruments() {
  return (
    <div class="instruments">
      <Point />
      <LayersPlot />
      <MeasuresTable />
      <Diagrams />
    </div>
  );
}
