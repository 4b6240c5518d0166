/** Invitations: made, copied while they are shown, listed, revoked. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import type { Invitation } from "../api";
import { askBefore } from "../dialog";
import type { Desk, View } from "../desk";
import { codeButton } from "./code";
import { copyButton } from "./copy";
import { boxed, head, row } from "./table";

const MOST = 1000;

export function invitations(desk: Desk): View {
  const words = desk.speech.words.invitations;
  const links = element("div", { "aria-live": "polite" });
  const list = element("div");
  let sign = "";
  const look = async () => {
    const found = await desk.lab.invitations();
    const now = JSON.stringify(found);
    if (now === sign) return;
    sign = now;
    const held = document.activeElement?.id ?? "";
    list.replaceChildren(listed(desk, found));
    if (held !== "") document.getElementById(held)?.focus();
  };
  const node = element(
    "div",
    {},
    element("h2", {}, words.title),
    element(
      "section",
      { class: "card" },
      element("p", { class: "soft" }, words.lead),
      form(desk, () => showLinks(desk, links)),
      links,
    ),
    list,
  );
  showLinks(desk, links);
  return { node, update: look };
}

function form(desk: Desk, made: () => void): HTMLFormElement {
  const words = desk.speech.words.invitations;
  const count = element("input", {
    type: "number",
    id: "count",
    min: 1,
    max: MOST,
    value: 1,
    required: true,
  });
  const label = element("input", { type: "text", id: "label", required: true, maxlength: 200 });
  const submit = element("button", { type: "submit", class: "main" }, words.make);
  const asked = element(
    "form",
    { class: "invite" },
    element("label", { for: "count", class: "field" }, words.count),
    count,
    element("label", { for: "label", class: "field" }, words.label),
    label,
    submit,
  );
  asked.addEventListener("submit", (event) => {
    event.preventDefault();
    submit.disabled = true;
    void desk
      .act(async () => {
        const told = await desk.lab.invite(count.valueAsNumber, label.value.trim());
        desk.kept.links.push(...told.links);
        made();
      })
      .finally(() => {
        submit.disabled = false;
      });
  });
  return asked;
}

function showLinks(desk: Desk, node: HTMLElement): void {
  const { links } = desk.kept;
  if (links.length === 0) {
    node.replaceChildren();
    return;
  }
  const words = desk.speech.words.invitations;
  const hide = button(
    words.hide,
    () => {
      links.length = 0;
      showLinks(desk, node);
    },
    { class: "small" },
  );
  node.replaceChildren(
    element("p", { class: "made" }, element("b", {}, fill(words.made, { count: links.length }))),
    element("p", { class: "row" }, copyButton(desk, links.join("\n"), words.copy_all), hide),
    element(
      "ul",
      { class: "links" },
      ...links.map((link) =>
        element(
          "li",
          {},
          element("code", {}, link),
          element("span", { class: "row" }, copyButton(desk, link), codeButton(desk, link)),
        ),
      ),
    ),
  );
}

function listed(desk: Desk, found: Invitation[]): HTMLElement {
  const words = desk.speech.words.invitations;
  if (found.length === 0) return element("p", { class: "soft" }, words.none);
  const heads = [words.for, words.made_at, words.made_by, words.used, words.actions];
  const rows = found.map((one) => row(heads, cells(desk, one), classOf(one))).reverse();
  const body = element("tbody", { role: "rowgroup" }, ...rows);
  return boxed(words.title, element("table", {}, head(heads), body));
}

function classOf(one: Invitation): Record<string, string> {
  return { class: one.revoked_at === null ? "" : "excluded" };
}

function cells(desk: Desk, one: Invitation): HTMLTableCellElement[] {
  const { speech } = desk;
  const words = speech.words.invitations;
  const time = speech.moment(one.made_at);
  const revoke = button(
    words.revoke,
    () => {
      void askBefore({
        title: words.revoke_title,
        note: fill(words.revoke_note, { label: one.label }),
        act: words.revoke,
        cancel: speech.words.people.cancel,
      }).then((given) => {
        if (given !== null) void desk.act(() => desk.lab.revokeInvitation(one.id));
      });
    },
    {
      id: `revoke-${one.id}`,
      class: "small",
      "aria-label": fill(words.revoke_of, { label: one.label, time }),
    },
  );
  const open = one.number === null && one.revoked_at === null;
  return [
    element("th", { scope: "row" }, one.label),
    element("td", { class: "nowrap" }, time),
    element("td", {}, one.made_by),
    element("td", {}, state(desk, one)),
    element("td", { class: "actions" }, open ? revoke : ""),
  ];
}

function state(desk: Desk, one: Invitation): string {
  const words = desk.speech.words.invitations;
  if (one.revoked_at !== null) return words.revoked;
  return one.number === null ? words.unused : fill(words.used_by, { number: one.number });
}
