import type { Declaration, Kind } from "./types";
export declare function declarations(kind: Kind): readonly Declaration[];
