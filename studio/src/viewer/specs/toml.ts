import type { Kind, SpecOf } from "./types";
export declare function toToml<K extends Kind>(kind: K, spec: SpecOf[K]): string;
