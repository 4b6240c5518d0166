/** What is wrong with a spec: what the command line would say of its file. */

import { type Complaint, type Pearl, type Scene, fromToml, toToml } from "../specs/spec";

const known = new WeakMap<object, readonly Complaint[]>();

/** The complaints about a spec as it stands; asked once of each. */
export function faultsOf(kind: "pearl", spec: Pearl): readonly Complaint[];
export function faultsOf(kind: "scene", spec: Scene): readonly Complaint[];
export function faultsOf(kind: "pearl" | "scene", spec: Pearl | Scene): readonly Complaint[] {
  const found = known.get(spec);
  if (found !== undefined) return found;
  const text = kind === "pearl" ? toToml(kind, spec as Pearl) : toToml(kind, spec as Scene);
  const read = fromToml(kind, text, kind);
  const faults = read.ok ? [] : read.complaints;
  known.set(spec, faults);
  return faults;
}
