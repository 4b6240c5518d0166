/** How thin nacre may be: `nacreous/thinness.py`. */

import { general } from "./number";

const THINNEST_NM = 1;
const THINNEST_PROTEIN_NM = 0.1;

/** `thin_layers`: what is wrong with layers that are all thinner than two cells of aragonite. */
export function thinLayers(thicknessNm: readonly number[]): string | undefined {
  const thickest = thicknessNm.reduce((most, one) => Math.max(most, one), 0);
  if (thickest >= THINNEST_NM || !(thickest > 0)) return undefined;
  return `is at most ${general(thickest)}; allowed: a layer of ${THINNEST_NM} nm or more (is it in um?)`;
}

/** `thin_protein`: likewise with protein thinner than an atom. */
export function thinProtein(proteinNm: number): string | undefined {
  if (!(proteinNm > 0 && proteinNm < THINNEST_PROTEIN_NM)) return undefined;
  return `is ${general(proteinNm)}; allowed: 0, or ${THINNEST_PROTEIN_NM} nm or more (is it in um?)`;
}
