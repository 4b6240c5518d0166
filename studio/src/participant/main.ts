/** The participant's page: a way through the study, and what stands at its end. */

import "../shared/style.css";
import "./participant.css";
import { element } from "../shared/dom";
import { Problem } from "../shared/http";
import { preferred } from "../shared/language";
import { paint } from "./grey";
import { Sitting, studyTold } from "./sitting";
import { Kept } from "./storage/kept";
import { claim } from "./storage/tabs";
import { Notice } from "./notice";
import { Ended, endOf, endPage, pays } from "./pages/ends";
import { Stage } from "./stage";
import type { Simulation } from "./stage";
import { WORDS } from "./words/words";

async function main(): Promise<void> {
  const root = element("main");
  const notice = new Notice();
  document.body.replaceChildren(root, notice.root);
  // Another link in the same tab changes nothing but what stands behind the #.
  addEventListener("hashchange", () => location.reload());

  const words = WORDS[preferred(["en", "ja"], navigator.languages)];
  const stage = new Stage(root, simulation());
  const study = await studyTold((yes) => (yes ? notice.hide() : notice.show(words.unreachable)));
  paint(study.background_code);
  const kept = await Kept.open();
  const sitting = new Sitting(stage, notice, kept, study);
  const { end, ending } = (await claim(study.name)) ? await ended(sitting) : new Ended("tabs");
  // Whoever comes by an address of their own is not followed by another person by the same.
  const own = Object.keys(sitting.parameters).length > 0 || pays(ending);
  const another = end === "thanks" && study.registration === "open" && !own;
  if ((await stage.show(endPage(sitting.words, end, another, ending))) === "next") {
    await sitting.forget();
  }
  location.reload();
}

/** How a sitting ends. */
async function ended(sitting: Sitting): Promise<Ended> {
  try {
    await sitting.run();
    return new Ended("thanks");
  } catch (reason) {
    if (reason instanceof Ended) return reason;
    if (reason instanceof Problem) return new Ended(endOf(reason));
    console.error(reason);
    return new Ended("broken");
  }
}

/** How the address asks for a simulation: ?simulate=visual or ?simulate=data-only. */
function simulation(): Simulation | null {
  const asked = new URLSearchParams(location.search).get("simulate");
  return asked === "visual" || asked === "data-only" ? asked : null;
}

void main();
