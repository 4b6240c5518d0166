/** The viewer: where it begins. */

import { effect } from "@preact/signals";
import { render } from "preact";
import "./files.css";
import "./viewer.css";
import { Page } from "./panels/Page";
import { keepAddress, openLink } from "./state/files";
import { canUndo, moving, specs } from "./state/store";

addEventListener("hashchange", () => void openLink());

await openLink(); // before the first picture, which would be another
const root = document.createElement("div");
root.id = "viewer";
document.body.append(root);
render(<Page />, root);

/** How long after the last change the address follows, in ms: browsers let a page change it some six times a second. */
const ADDRESS_MS = 300;
let following: ReturnType<typeof setTimeout> | undefined;

effect(() => {
  const isChanged = canUndo.value;
  clearTimeout(following);
  if (isChanged && specs.value && !moving.value) {
    following = setTimeout(() => void keepAddress(), ADDRESS_MS);
  }
});
