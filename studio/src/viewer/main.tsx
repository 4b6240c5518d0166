/** The viewer: where it begins. */

import { render } from "preact";
import "./viewer.css";
import { Page } from "./panels/Page";
import { openLink } from "./state/files";

void openLink();
addEventListener("hashchange", () => void openLink());

const root = document.createElement("div");
root.id = "viewer";
document.body.append(root);
render(<Page />, root);
