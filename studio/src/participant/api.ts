/** What a participant's pages ask of the server. */

import { ask, send } from "../shared/http";
import type { Language, Said } from "../shared/language";

export interface ScreenRules {
  least_width_px: number;
  least_height_px: number;
  if_smaller: "flag" | "refuse";
  full_screen: boolean;
  card: boolean;
  distance: boolean;
  levels: boolean;
  vision: ("contrast" | "colour")[];
}

export interface Factor {
  name: string;
  question: Said;
  choices: { value: string; text: Said }[];
}

export interface Study {
  name: string;
  purpose: "study" | "demo";
  state: "open" | "paused" | "closed";
  registration: "open" | "invited";
  languages: Language[];
  consent: Said;
  instructions: Said;
  questions: { id: string; text: Said }[];
  groups: Factor[];
  sitting: { training: number; break_every: number; minimum_viewing_ms: number; ties: boolean };
  screen: ScreenRules;
  /** For whoever enters without an invitation. */
  token: string;
}

export interface Trial {
  trial: number;
  question: string;
  left: string;
  right: string;
  training: boolean;
  break_before: boolean;
}

export interface Picture {
  width_px: number;
  height_px: number;
  width_mm: number;
}

export interface SittingTold {
  /** Its name, which no other sitting gets, whatever becomes of token or number. */
  sitting: string;
  number: number;
  language: Language;
  consented: boolean;
  screened: boolean;
  screen_flags: string[];
  refused: boolean;
  finished: boolean;
  answered: number;
  groups_notes: Said[];
  trials: Trial[];
  pictures: Record<string, Picture>;
}

export type Chosen = "left" | "right" | "tie";

export interface Answer {
  trial: number;
  chosen: Chosen;
  /** Null where it is not known. */
  response_ms: number | null;
  shown_at: string;
  answered_at: string;
  flags: Record<string, string | number | boolean>;
  simulated: boolean;
}

/** What the server says to anybody. */
export const study = (): Promise<Study> => ask<Study>("/api/study");

/** What it says to the holder of a token. */
export class Api {
  constructor(readonly token: string) {}

  enter(language: Language, groups: Record<string, string>): Promise<SittingTold> {
    return this.post("/api/enter", { language, groups });
  }

  sitting(): Promise<SittingTold> {
    return ask<SittingTold>("/api/sitting", { headers: this.headers });
  }

  consent(): Promise<void> {
    return this.post("/api/consent", {});
  }

  screen(content: object): Promise<{ flags: string[]; refused: boolean }> {
    return this.post("/api/screen", { content });
  }

  async answer({ trial, ...answer }: Answer): Promise<void> {
    await ask(`/api/answers/${trial}`, { method: "PUT", body: answer, headers: this.headers });
  }

  finish(): Promise<void> {
    return this.post("/api/finish", {});
  }

  withdraw(): Promise<void> {
    return this.post("/api/withdraw", {});
  }

  async picture(sha256: string): Promise<Blob> {
    const response = await send(`/api/pictures/${sha256}`, { headers: this.headers });
    return response.blob();
  }

  private post<T>(path: string, body: object): Promise<T> {
    return ask<T>(path, { method: "POST", body, headers: this.headers });
  }

  private get headers(): Record<string, string> {
    return { Authorization: `Bearer ${this.token}` };
  }
}
