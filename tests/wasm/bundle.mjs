// The bundle that `./just wasm` builds, ready to be asked.

import { readFileSync } from "node:fs";

import * as nacreous from "../../target/wasm/nacreous.js";

export const near = (path) => new URL(path, import.meta.url);

nacreous.initSync({ module: readFileSync(near("../../target/wasm/nacreous_bg.wasm")) });

export { nacreous };
