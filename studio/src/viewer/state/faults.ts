/** What is wrong with a spec: what the command line would say of its file. */

import { type Complaint, type Pearl, type Scene, fromToml, toToml } from "../specs/spec";
import { droppedNames } from "./dropped";

interface Known {
  readonly names: ReadonlySet<string>;
  readonly faults: readonly Complaint[];
}

const known = new WeakMap<object, Known>();

/** The complaints about a spec as it stands; asked once of each, and again when a file is dropped. */
export function faultsOf(kind: "pearl", spec: Pearl): readonly Complaint[];
export function faultsOf(kind: "scene", spec: Scene): readonly Complaint[];
export function faultsOf(kind: "pearl" | "scene", spec: Pearl | Scene): readonly Complaint[] {
  const names = droppedNames.value;
  const found = known.get(spec);
  if (found?.names === names) return found.faults;
  const text = kind === "pearl" ? toToml(kind, spec as Pearl) : toToml(kind, spec as Scene);
  const read = fromToml(kind, text, kind, names);
  const faults = read.ok ? [] : read.complaints;
  known.set(spec, { names, faults });
  return faults;
}
