/** Pearl and scene specs in the browser: read, checked, completed and written, as Python does. */

export type * from "./types";
export { Refusal } from "./types";
export { declarations } from "./declarations";
export { fromBytes, fromToml, open, read } from "./read";
export { toToml } from "./toml";
export { recipeJson } from "./recipe";
export { fromFragment, toFragment } from "./link";
