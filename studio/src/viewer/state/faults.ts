/** What is wrong with a spec: what the command line would say of its file. */

import { type Complaint, type Kind, type SpecOf, fromToml, toToml } from "../specs/spec";

const known = new WeakMap<object, readonly Complaint[]>();

/** The complaints about a spec as it stands; asked once of each. */
export function faultsOf<K extends Kind>(kind: K, spec: SpecOf[K]): readonly Complaint[] {
  const found = known.get(spec);
  if (found !== undefined) return found;
  const read = fromToml(kind, toToml(kind, spec), kind);
  const faults = read.ok ? [] : read.complaints;
  known.set(spec, faults);
  return faults;
}
