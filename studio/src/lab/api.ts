/** What the laboratory asks of the server. */

import { ask, Problem } from "../shared/http";
import type { Said } from "../shared/language";

export type State = "open" | "paused" | "closed";
export type Registration = "open" | "invited";

export interface Flag {
  kind: string;
  detail: string;
}

export interface Person {
  number: number;
  language: string | null;
  groups: Record<string, string>;
  answers: number;
  trials: number;
  started_at: string;
  last_at: string | null;
  finished: boolean;
  seconds: number | null;
  excluded: string | null;
  erased: boolean;
  simulated: boolean;
  screen_flags: string[];
  flags: Flag[];
}

export interface Progress {
  name: string;
  study: string;
  purpose: "study" | "demo";
  state: State;
  registration: Registration;
  entered: number;
  consented: number;
  finished: number;
  excluded: number;
  erased: number;
  answers: number;
  simulated: number;
  median_s: number | null;
  trials: number;
  people: Person[];
}

export interface Placed {
  label: string;
  picture: string;
  value: number;
  low: number;
  high: number;
}

export interface Scale {
  question: string;
  text: Said;
  stimuli: Placed[];
  answers: number;
  people: number;
  unit: string;
  level: number;
  verdict: string;
  misfit?: [string, string] | null;
}

export interface Invitation {
  id: string;
  label: string;
  made_at: string;
  made_by: string;
  number: number | null;
  revoked_at: string | null;
}

export interface Event {
  at: string;
  who: string;
  what: string;
  number: number | null;
  detail: Record<string, unknown>;
}

export interface Question {
  id: string;
  text: Said;
}

/** What everybody may know of the study. */
export interface Study {
  name: string;
  state: State;
  questions: Question[];
}

export interface Me {
  name: string;
  csrf: string;
}

const API = "/lab/api";

/** The laboratory's side of the conversation; the browser keeps the cookie, this keeps the CSRF token. */
export class Lab {
  me: Me | null = null;

  /** `onEnd` is called whenever the server no longer knows who we are. */
  constructor(private readonly onEnd: () => void) {}

  /** Who is logged in; null if nobody is. Not asked where nobody has logged in before. */
  async whoAmI(): Promise<Me | null> {
    if (!hasBeenHere()) return null;
    try {
      this.me = await ask<Me>(`${API}/me`);
    } catch (problem) {
      if (!(problem instanceof Problem && problem.status === 401)) throw problem;
      this.me = null;
    }
    return this.me;
  }

  async login(name: string, password: string): Promise<Me> {
    this.me = await ask<Me>(`${API}/login`, { method: "POST", body: { name, password } });
    noteHere(true);
    return this.me;
  }

  async logout(): Promise<void> {
    await this.change("/logout", {});
    noteHere(false);
    this.me = null;
  }

  progress = () => this.get<Progress>("/progress");
  invitations = () => this.get<Invitation[]>("/invitations");
  events = () => this.get<Event[]>("/events?last=200");
  study = () => ask<Study>("/api/study");

  scale(question: string, simulated: boolean) {
    const query = new URLSearchParams({ question, simulated: String(simulated) });
    return this.get<Scale | { problem: string }>(`/scale?${query}`);
  }

  setState = (state: State) => this.change("/state", { state });
  setRegistration = (registration: Registration) => this.change("/registration", { registration });
  invite = (count: number, label: string) =>
    this.change<{ links: string[] }>("/invitations", { count, label });
  revokeInvitation = (id: string) =>
    this.change(`/invitations/${encodeURIComponent(id)}/revoke`, {});
  exclude = (number: number, reason: string) =>
    this.change(`/people/${number}/exclude`, { reason });
  readmit = (number: number) => this.change(`/people/${number}/readmit`, {});
  revoke = (number: number) => this.change(`/people/${number}/revoke`, {});

  private get<T>(path: string): Promise<T> {
    return this.known(ask<T>(API + path));
  }

  private change<T = unknown>(path: string, body: unknown): Promise<T> {
    const headers = { "X-CSRF-Token": this.me?.csrf ?? "" };
    return this.known(ask<T>(API + path, { method: "POST", body, headers }));
  }

  private async known<T>(answer: Promise<T>): Promise<T> {
    try {
      return await answer;
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

/** Where the report of a question is. */
export function reportAt(question: string, language: string, simulated: boolean): string {
  return `${API}/report?${new URLSearchParams({ question, language, simulated: String(simulated) })}`;
}

/** Where all answers are. */
export const ANSWERS_AT = `${API}/answers.csv`;

/** Where a picture is. */
export function pictureAt(sha256: string): string {
  return `${API}/pictures/${sha256}`;
}
