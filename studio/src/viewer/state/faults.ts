/** What is wrong with a spec: what the command line would say of its file. */

import {
  type Complaint,
  type Kind,
  type Pearl,
  type Scene,
  type Specs,
  fromToml,
  toToml,
} from "../specs/spec";
import { droppedNames } from "./dropped";

interface Known {
  readonly names: ReadonlySet<string>;
  readonly faults: readonly Complaint[];
}

const known = new WeakMap<object, Known>();

/** A complaint about the pearl or the scene that is shown. */
export interface Fault extends Complaint {
  readonly kind: Kind;
}

/** All complaints about a pearl in its scene. */
export function faultsIn({ pearl, scene }: Specs): readonly Fault[] {
  const of = (kind: Kind) => (one: Complaint) => ({ ...one, kind });
  return [
    ...faultsOf("pearl", pearl).map(of("pearl")),
    ...faultsOf("scene", scene).map(of("scene")),
  ];
}

/** The complaints about a spec as it stands; asked once of each, and again when a file is dropped. */
function faultsOf(kind: "pearl", spec: Pearl): readonly Complaint[];
function faultsOf(kind: "scene", spec: Scene): readonly Complaint[];
function faultsOf(kind: "pearl" | "scene", spec: Pearl | Scene): readonly Complaint[] {
  const names = droppedNames.value;
  const found = known.get(spec);
  if (found?.names === names) return found.faults;
  const text = kind === "pearl" ? toToml(kind, spec as Pearl) : toToml(kind, spec as Scene);
  const read = fromToml(kind, text, kind, names);
  const faults = read.ok ? [] : read.complaints;
  known.set(spec, { names, faults });
  return faults;
}
