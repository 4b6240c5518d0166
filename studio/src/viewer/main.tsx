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

effect(() => {
  const isChanged = canUndo.value;
  if (isChanged && specs.value && !moving.value) void keepAddress();
});
