/** Pearl and scene specs in the browser: read, checked, completed and written, as Python does. */

export type * from "./types";
export { Refusal } from "./types";
export { declarations } from "./declarations";
export { type AnySpec, fromBytes, fromToml, open, read } from "./read";
export { toToml } from "./write";
export { recipeJson, recipeTexts } from "./recipe";
export { fromFragment, toFragment } from "./link";
export { label } from "./words";
export { NACRES, PEARLS, SCENES, summary } from "./presets";
