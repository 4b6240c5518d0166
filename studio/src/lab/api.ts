/** What the laboratory asks of the server. */

import { addressOf, ask, Problem } from "../shared/http";
import type { FileRoute, Options, Route } from "../shared/http";
import type { Language } from "../shared/language";
import type { ProgressTold, Routes, WhoTold } from "../shared/wire";

export type {
  EventTold as Event,
  FlagTold as Flag,
  InvitationTold as Invitation,
  PersonTold as Person,
  ProgressTold as Progress,
  ScaleTold as Scale,
  StimulusTold as Placed,
  StudyTold as Study,
} from "../shared/wire";

export type State = ProgressTold["state"];
export type Registration = ProgressTold["registration"];

/** The laboratory's side of the conversation; the browser keeps the cookie, this keeps the CSRF token. */
export class Lab {
  me: WhoTold | null = null;

  /** `onEnd` is called whenever the server no longer knows who we are. */
  constructor(private readonly onEnd: () => void) {}

  /** Who is logged in; null if nobody is. Not asked where nobody has logged in before. */
  async whoAmI(): Promise<WhoTold | null> {
    if (!hasBeenHere()) return null;
    try {
      this.me = await ask("GET /lab/api/me", undefined);
    } catch (problem) {
      if (!(problem instanceof Problem && problem.status === 401)) throw problem;
      this.me = null;
    }
    return this.me;
  }

  async login(name: string, password: string): Promise<WhoTold> {
    this.me = await ask("POST /lab/api/login", { name, password });
    noteHere(true);
    return this.me;
  }

  async logout(): Promise<void> {
    await this.ask("POST /lab/api/logout", undefined);
    noteHere(false);
    this.me = null;
  }

  progress = () => this.ask("GET /lab/api/progress", undefined);
  invitations = () => this.ask("GET /lab/api/invitations", undefined);
  events = () => this.ask("GET /lab/api/events", undefined, { query: { last: 200 } });
  study = () => ask("GET /api/study", undefined);
  scale = (question: string, simulated: boolean) =>
    this.ask("GET /lab/api/scale", undefined, { query: { question, simulated } });

  setState = (state: State) => this.ask("POST /lab/api/state", { state });
  setRegistration = (registration: Registration) =>
    this.ask("POST /lab/api/registration", { registration });
  invite = (count: number, label: string) =>
    this.ask("POST /lab/api/invitations", { count, label });
  revokeInvitation = (invitation: number) =>
    this.ask("POST /lab/api/invitations/{invitation}/revoke", undefined, {
      places: { invitation },
    });
  exclude = (number: number, reason: string) =>
    this.ask("POST /lab/api/people/{number}/exclude", { reason }, { places: { number } });
  readmit = (number: number) =>
    this.ask("POST /lab/api/people/{number}/readmit", undefined, { places: { number } });
  revoke = (number: number) =>
    this.ask("POST /lab/api/people/{number}/revoke", undefined, { places: { number } });

  private async ask<R extends Exclude<Route, FileRoute>>(
    route: R,
    body: Routes[R]["body"],
    options: Pick<Options, "places" | "query"> = {},
  ): Promise<Routes[R]["told"]> {
    const headers: Record<string, string> = route.startsWith("GET")
      ? {}
      : { "X-CSRF-Token": this.me?.csrf ?? "" };
    try {
      return await ask(route, body, { ...options, headers });
    } catch (problem) {
      if (problem instanceof Problem && problem.status === 401) this.onEnd();
      throw problem;
    }
  }
}

const HERE = "nacreous-lab-here";

/** Whether somebody has logged in with this browser and not out; true where nothing can be kept. */
function hasBeenHere(): boolean {
  try {
    return localStorage.getItem(HERE) !== null;
  } catch {
    return true;
  }
}

function noteHere(here: boolean): void {
  try {
    if (here) localStorage.setItem(HERE, "1");
    else localStorage.removeItem(HERE);
  } catch {
    // Then the server is asked each time.
  }
}

/** A file that the server makes, and what to ask for it. */
export interface File {
  route: FileRoute;
  query: Record<string, string | boolean>;
}

/** The report of a question. */
export function report(question: string, language: Language, simulated: boolean): File {
  return { route: "GET /lab/api/report", query: { question, language, simulated } };
}

/** A table as CSV; bom: beginning as Excel wants it. */
export function table(which: "answers" | "people", bom: boolean): File {
  return { route: `GET /lab/api/${which}.csv`, query: { bom } };
}

/** Where a picture is. */
export function pictureAt(sha256: string): string {
  return addressOf("GET /lab/api/pictures/{sha256}", { places: { sha256 } });
}
