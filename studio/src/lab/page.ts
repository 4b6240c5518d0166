/** The frame around the views: who is logged in, the language, the tabs, what went wrong. */

import { button, element } from "../shared/dom";
import { fill, NAMES } from "../shared/language";
import type { Progress, State } from "./api";
import type { Desk, View } from "./desk";
import { invitations } from "./views/invitations";
import { log } from "./views/log";
import { overview } from "./views/overview";
import { people } from "./views/people";
import { scale } from "./views/scale";
import { LANGUAGES, type Speech } from "./words/speech";

const TABS = { overview, people, scale, invitations, log };
type Tab = keyof typeof TABS;

export interface Doing {
  logOut: () => void;
  speak: (language: "en" | "ja") => void;
  look: () => void;
}

/** The page in one language; made anew in another. */
export class Page {
  readonly node: HTMLElement;
  private readonly main = element("main", { id: "content", tabindex: -1 });
  private readonly banner = element("div", { class: "banners", role: "alert" });
  private readonly heading = element("h1");
  private readonly badge = element("span", { class: "badge" });
  private readonly links = new Map<Tab, HTMLAnchorElement>();
  private readonly views = new Map<Tab, View>();

  constructor(
    private readonly desk: Desk,
    private readonly doing: Doing,
  ) {
    const { words } = desk.speech;
    const nav = element("nav", { "aria-label": words.laboratory });
    for (const tab of Object.keys(TABS) as Tab[]) {
      const link = element("a", { href: `#${tab}` }, words.tabs[tab]);
      this.links.set(tab, link);
      nav.append(link);
    }
    this.node = element(
      "div",
      { class: "lab" },
      element("a", { href: "#content", class: "skip" }, words.skip),
      element(
        "header",
        {},
        element("div", { class: "title" }, this.heading, this.badge),
        element(
          "div",
          { class: "row who" },
          languages(desk.speech, doing.speak),
          element(
            "span",
            { class: "soft" },
            fill(words.logged_in_as, { name: desk.lab.me?.name ?? "" }),
          ),
          button(words.log_out, doing.logOut, { class: "small" }),
        ),
        nav,
      ),
      this.banner,
      this.main,
    );
    this.head(desk.study);
    this.node.querySelector(".skip")?.addEventListener("click", (event) => {
      event.preventDefault();
      this.main.focus();
    });
  }

  get tab(): Tab {
    return tabOf(this.desk.kept.tab);
  }

  /** Show the view that the address names. */
  open(tab: string): void {
    this.desk.kept.tab = tabOf(tab);
    for (const [name, link] of this.links) {
      if (name === this.tab) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    this.main.replaceChildren(this.view.node);
    this.doing.look();
  }

  /** The newest figures. */
  async update(progress: Progress): Promise<void> {
    this.head(progress);
    await this.view.update(progress);
  }

  private head({ name, state }: { name: string; state: State }): void {
    const { words } = this.desk.speech;
    this.heading.textContent = name;
    this.badge.textContent = words.state[state];
    this.badge.className = `badge ${state}`;
    document.title = fill(words.title, { study: name });
  }

  /** What went wrong, until it is closed or passes; "" for nothing. */
  say(told: string, passing: boolean): void {
    const same = this.banner.querySelector(passing ? ".passing" : ".lasting");
    if (same?.querySelector("span")?.textContent === told) return;
    same?.remove();
    if (told === "") return;
    const note = element(
      "p",
      { class: passing ? "banner passing" : "banner lasting" },
      element("span", {}, told),
    );
    if (!passing) {
      note.append(
        button("×", () => note.remove(), { "aria-label": this.desk.speech.words.trouble.dismiss }),
      );
    }
    this.banner.append(note);
  }

  private get view(): View {
    const found = this.views.get(this.tab) ?? TABS[this.tab](this.desk);
    this.views.set(this.tab, found);
    return found;
  }
}

function tabOf(name: string): Tab {
  return name in TABS ? (name as Tab) : "overview";
}

/** The choice of language, each called as it calls itself. */
export function languages(speech: Speech, speak: Doing["speak"]): HTMLElement {
  const made = LANGUAGES.map((language) =>
    button(NAMES[language], () => speak(language), {
      class: "small language",
      lang: language,
      "aria-pressed": String(language === speech.language),
    }),
  );
  return element(
    "div",
    { class: "languages", role: "group", "aria-label": speech.words.language },
    ...made,
  );
}
