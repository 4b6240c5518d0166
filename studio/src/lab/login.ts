/** The login: the first thing seen, and again over the page when a session has ended. */

import { element } from "../shared/dom";
import { Problem } from "../shared/http";
import { fill } from "../shared/language";
import type { Lab } from "./api";
import type { Speech } from "./words/speech";

/** A form that calls `done` once somebody is logged in. `name`: who was before. */
export function loginForm(
  lab: Lab,
  speech: Speech,
  name: string,
  done: () => void,
): HTMLFormElement {
  const words = speech.words.login;
  const who = element("input", {
    type: "text",
    id: "name",
    autocomplete: "username",
    autocapitalize: "none",
    spellcheck: "false",
    required: true,
    maxlength: 40,
    value: name,
  });
  const password = element("input", {
    type: "password",
    id: "password",
    autocomplete: "current-password",
    required: true,
    maxlength: 200,
  });
  const submit = element("button", { type: "submit", class: "main" }, words.submit);
  const trouble = element("p", { class: "trouble", role: "alert" });
  const form = element(
    "form",
    { class: "login" },
    element("label", { for: "name", class: "field" }, words.name),
    who,
    element("label", { for: "password", class: "field" }, words.password),
    password,
    trouble,
    submit,
  );
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    submit.disabled = true;
    trouble.textContent = "";
    lab
      .login(who.value, password.value)
      .then(done)
      .catch((problem: unknown) => {
        trouble.textContent = said(problem, speech);
        password.select();
      })
      .finally(() => {
        submit.disabled = false;
      });
  });
  return form;
}

/** The login over the page; what was open stays as it is. */
export function loginAgain(lab: Lab, speech: Speech, done: () => void): void {
  if (document.querySelector("dialog.ended") !== null) return;
  const dialog = element("dialog", { class: "ended", "aria-labelledby": "ended-title" });
  const form = loginForm(lab, speech, lab.me?.name ?? "", () => {
    dialog.close();
    dialog.remove();
    done();
  });
  dialog.append(
    element("h2", { id: "ended-title" }, speech.words.login.submit),
    element("p", {}, speech.words.login.ended),
    form,
  );
  dialog.addEventListener("cancel", (event) => event.preventDefault());
  document.body.append(dialog);
  dialog.showModal();
}

function said(problem: unknown, speech: Speech): string {
  const { login, trouble } = speech.words;
  if (!(problem instanceof Problem)) return fill(trouble.failed, { problem: String(problem) });
  if (problem.status === 401) return login.wrong;
  if (problem.status === 429) {
    return fill(login.busy, { seconds: Math.ceil(problem.retryAfterMs / 1000) });
  }
  if (problem.status === 0) return fill(trouble.failed, { problem: problem.message });
  return fill(trouble.refused, { problem: problem.message });
}
