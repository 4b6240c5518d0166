import type { Read, Specs } from "./types";
export declare function toFragment(specs: Specs): Promise<string>;
export declare function fromFragment(fragment: string): Promise<Read<Specs>>;
