import type { Specs } from "./types";
/** Throws a Refusal where the scene's rows ask for more pearls than one. */
export declare function recipeJson(specs: Specs, size: number, samples: number): string;
