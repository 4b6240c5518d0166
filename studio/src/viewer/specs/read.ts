import type { Kind, Read, SpecOf } from "./types";

/** Stub, filled in the next commits. `files`: names of the files dropped onto the page. */
export declare function read<K extends Kind>(
  kind: K,
  values: unknown,
  file: string,
  files?: ReadonlySet<string>,
): Read<SpecOf[K]>;
export declare function fromToml<K extends Kind>(
  kind: K,
  text: string,
  file: string,
  files?: ReadonlySet<string>,
): Read<SpecOf[K]>;
/** A dropped file's bytes: size, encoding and text are checked. */
export declare function fromBytes<K extends Kind>(
  kind: K,
  bytes: Uint8Array,
  file: string,
  files?: ReadonlySet<string>,
): Read<SpecOf[K]>;
/** A dropped file of either kind: its keys show which. */
export declare function open(
  bytes: Uint8Array,
  file: string,
  files?: ReadonlySet<string>,
): Read<{ kind: "pearl"; spec: SpecOf["pearl"] } | { kind: "scene"; spec: SpecOf["scene"] }>;
