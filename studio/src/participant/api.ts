/** What a participant's pages ask of the server. */

import { ask, bring } from "../shared/http";
import type { FileRoute, Route } from "../shared/http";
import type { Language } from "../shared/language";
import type { Answering, Routes, ScreenTold, SittingTold, StudyTold } from "../shared/wire";
import type { ScreenContent } from "./screen/content";

export type {
  EndingTold as Ending,
  GroupTold as Factor,
  PictureTold as Picture,
  Screen as ScreenRules,
  SittingTold,
  StudyTold as Study,
  TrialTold as Trial,
} from "../shared/wire";

export type Chosen = Answering["chosen"];

/** An answer with its trial, complete: null is said where something is not known. */
export type Answer = { trial: number } & Required<Answering>;

/** What the server says to anybody. */
export const study = (): Promise<StudyTold> => ask("GET /api/study", undefined);

/** What it says to the holder of a token. */
export class Api {
  constructor(readonly token: string) {}

  enter(
    language: Language,
    groups: Record<string, string>,
    parameters: Record<string, string>,
  ): Promise<SittingTold> {
    return this.ask("POST /api/enter", { language, groups, parameters });
  }

  sitting(): Promise<SittingTold> {
    return this.ask("GET /api/sitting", undefined);
  }

  consent(): Promise<void> {
    return this.ask("POST /api/consent", undefined);
  }

  screen(content: ScreenContent): Promise<ScreenTold> {
    return this.ask("POST /api/screen", { content });
  }

  async answer({ trial, ...answer }: Answer): Promise<void> {
    await this.ask("PUT /api/answers/{trial}", answer, { trial });
  }

  finish(): Promise<void> {
    return this.ask("POST /api/finish", undefined);
  }

  withdraw(): Promise<void> {
    return this.ask("POST /api/withdraw", undefined);
  }

  picture(sha256: string): Promise<Blob> {
    return bring("GET /api/pictures/{sha256}", { places: { sha256 }, headers: this.headers });
  }

  private ask<R extends Exclude<Route, FileRoute>>(
    route: R,
    body: Routes[R]["body"],
    places: Record<string, string | number> = {},
  ): Promise<Routes[R]["told"]> {
    return ask(route, body, { places, headers: this.headers });
  }

  private get headers(): Record<string, string> {
    return { Authorization: `Bearer ${this.token}` };
  }
}
