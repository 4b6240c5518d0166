/* Made by ./just types, never by hand. SHA-256 of its schema:
 * e3d87a37f33eacab4f04cdabf0eafa82702401763a0f9e2865677a12547d7f2e
 */

export type JsonValue = unknown;

/**
 * The answer to a trial; the trial itself is known.
 */
export interface Answering {
  chosen: "left" | "right" | "tie";
  response_ms?: number | null;
  shown_at?: string | null;
  answered_at?: string | null;
  flags?: {
    [k: string]: JsonValue;
  };
  simulated?: boolean;
}
/**
 * The size of a pixel, by a bank card held against the screen.
 */
export interface Card {
  /**
   * CSS pixels in a millimetre. Allowed: above 0 to 1000000 px/mm. Source: ISO/IEC 7810.
   */
  px_per_mm: number;
}
/**
 * What the browser found out about the screen.
 */
export interface Checking {
  content: ScreenCheck;
}
/**
 * What was found out about a screen; what nobody measured is None or left out.
 */
export interface ScreenCheck {
  /**
   * The window that pictures are shown in.
   */
  window?: Window | null;
  /**
   * Whether the pages fill the screen.
   */
  full_screen?: boolean | null;
  /**
   * The whole screen.
   */
  screen?: Monitor | null;
  /**
   * The size of a pixel, by a bank card.
   */
  card?: Card | null;
  /**
   * Width of the widest picture as it is meant to be on the screen. Allowed: 0 to 1000000 mm. Left out: the size of a pixel is not known. Source: the study's display.
   */
  picture_width_mm?: number | null;
  /**
   * From the eyes to the screen; of the blind spot, the median of all tries. Allowed: 0 to 1000000 mm. Left out: not known. Source: Li et al. 2020, Virtual Chinrest.
   */
  distance_mm?: number | null;
  /**
   * How the distance was found.
   */
  distance_by?: ("blind-spot" | "typed" | "none") | null;
  /**
   * The distance by each try with the blind spot. Allowed: up to 100 numbers, 0 to 1000000 mm. Left out: the blind spot was not tried. Source: Li et al. 2020, Virtual Chinrest.
   */
  distance_tries_mm?: number[] | null;
  /**
   * The exponent of the screen, matched by eye. Allowed: 0 to 1000000. Left out: not measured. Source: a grey as bright as stripes, half black and half white.
   */
  gamma?: number | null;
  /**
   * The first grey code above black that is seen; 255 where none is. Allowed: 0 to 255. Left out: not measured. Source: **(ours)**.
   */
  darkest_step?: number | null;
  /**
   * The widest gamut that the screen shows, as the browser says.
   */
  gamut?: ("less" | "srgb" | "p3" | "rec2020") | null;
  /**
   * Whether the screen has a high dynamic range, as the browser says.
   */
  hdr?: boolean | null;
  /**
   * The tests of the eyes that were made.
   */
  vision?: Vision | null;
  /**
   * The browser's family and version.
   */
  agent?: string | null;
  /**
   * Whether a simulated participant checked the screen.
   */
  simulated?: boolean | null;
}
/**
 * The window that pictures are shown in.
 */
export interface Window {
  /**
   * Width inside, in CSS pixels. Allowed: 0 to 1000000 px. Source: CSSOM View.
   */
  width_px: number;
  /**
   * Height inside, in CSS pixels. Allowed: 0 to 1000000 px. Source: CSSOM View.
   */
  height_px: number;
  /**
   * Pixels of the screen in a CSS pixel, across. Allowed: above 0 to 1000. Left out: not known. Source: CSSOM View.
   */
  device_pixel_ratio?: number | null;
}
/**
 * The whole screen.
 */
export interface Monitor {
  /**
   * Width, in CSS pixels. Allowed: 0 to 1000000 px. Source: CSSOM View.
   */
  width_px: number;
  /**
   * Height, in CSS pixels. Allowed: 0 to 1000000 px. Source: CSSOM View.
   */
  height_px: number;
  /**
   * Bits of a pixel's colour, as the browser says. Allowed: 0 to 1000 bits. Left out: not known. Source: CSSOM View.
   */
  colour_depth?: number | null;
}
/**
 * The tests of the eyes that were made.
 */
export interface Vision {
  /**
   * Rings of low contrast.
   */
  contrast?: Plates | null;
  /**
   * Digits that colour alone tells.
   */
  colour?: Plates | null;
}
/**
 * How many of the plates of one test of the eyes were read right.
 */
export interface Plates {
  /**
   * Plates read right. Allowed: 0 to 1000000. Source: **(ours)**.
   */
  right: number;
  /**
   * Plates shown. Allowed: 0 to 1000000. Source: **(ours)**.
   */
  of: number;
}
/**
 * A value of a group as people read it.
 */
export interface ChoiceTold {
  value: string;
  text: Words;
}
/**
 * Words in those languages of the study in which there are some.
 */
export interface Words {
  en?: string;
  ja?: string;
}
/**
 * What somebody is given who has finished: a completion code, and where to go back to.
 */
export interface EndingTold {
  code: string | null;
  return_url: string | null;
}
/**
 * Who comes: the language of the pages, and what was asked of each recorded group.
 *
 * parameters: of the address by which they came, those that the study keeps.
 */
export interface Entering {
  language: string;
  groups: {
    [k: string]: string;
  };
  parameters?: {
    [k: string]: string;
  };
}
/**
 * A line of the audit log; `number` is of the participant whom it is about.
 */
export interface EventTold {
  at: string;
  who: string;
  what: string;
  number: number | null;
  detail: {
    [k: string]: JsonValue;
  };
}
/**
 * Why a person's answers are not to be counted.
 */
export interface Excluding {
  reason: string;
}
/**
 * Something about a person's answers that an experimenter should know.
 */
export interface FlagTold {
  kind: string;
  detail: string;
}
/**
 * A factor that is asked of the participant.
 */
export interface GroupTold {
  name: string;
  question: Words;
  choices: ChoiceTold[];
}
/**
 * An invitation; `number` is of the participant who used it.
 */
export interface InvitationTold {
  id: number;
  label: string;
  made_at: string;
  made_by: string;
  number: number | null;
  revoked_at: string | null;
}
/**
 * How many invitations, and what experimenters call them.
 */
export interface Inviting {
  count: number;
  label: string;
}
/**
 * New invitations, each a link that is told only once.
 */
export interface LinksTold {
  links: string[];
}
/**
 * An experimenter's name and password.
 */
export interface LoggingIn {
  name: string;
  password: string;
}
/**
 * Whether people may enter.
 */
export interface Opening {
  state: "open" | "paused" | "closed";
}
/**
 * How far one participant is, practice aside. Of an erased one `trials` is 0.
 */
export interface PersonTold {
  number: number;
  language: ("en" | "ja") | null;
  groups: {
    [k: string]: string;
  };
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
  flags: FlagTold[];
}
/**
 * How large a picture is, in its own pixels and on the screen.
 */
export interface PictureTold {
  width_px: number;
  height_px: number;
  width_mm: number;
}
/**
 * What every refusal looks like.
 */
export interface Problem {
  problem: string;
  kind:
    | "input"
    | "token"
    | "not-allowed"
    | "conflict"
    | "turn"
    | "busy"
    | "store"
    | "missing"
    | "fault";
}
/**
 * How far the study is. `trials` is what a full sitting has.
 *
 * flags_known: whether anybody's flags are worked out; before, nobody has any. They may be of a
 * moment ago.
 */
export interface ProgressTold {
  name: string;
  study: string;
  purpose: "study" | "demo";
  state: "open" | "paused" | "closed";
  registration: "open" | "invited";
  entered: number;
  consented: number;
  finished: number;
  excluded: number;
  erased: number;
  answers: number;
  simulated: number;
  median_s: number | null;
  trials: number;
  flags_known: boolean;
  people: PersonTold[];
}
/**
 * A question as people read it.
 */
export interface QuestionTold {
  id: string;
  text: Words;
}
/**
 * That an answer is on the disk; `again`: it was already.
 */
export interface ReceiptTold {
  trial: number;
  received_at: string;
  again: boolean;
}
/**
 * Who may enter.
 */
export interface Registering {
  registration: "open" | "invited";
}
/**
 * The scale so far.
 */
export interface ScaleTold {
  question: string;
  text: Words;
  simulated: boolean;
  stimuli: StimulusTold[];
  answers: number;
  people: number;
  unit: "z" | "d'" | "JOD" | "JND" | "logit";
  level: number;
  verdict: "describes" | "misfits" | "untested";
  misfit: [string, string] | null;
  people_differ: boolean;
  people_told: boolean;
}
/**
 * A stimulus on the scale, with its interval; null: an end that the answers do not set.
 */
export interface StimulusTold {
  label: string;
  picture: string;
  value: number;
  low: number | null;
  high: number | null;
}
/**
 * What is asked of a participant's screen, and what follows where it falls short.
 */
export interface Screen {
  /**
   * The least width of the window, in the browser's pixels. Allowed: 200 to 10000. Source: **(ours)**.
   */
  least_width_px: number;
  /**
   * The least height of the window, in the browser's pixels. Allowed: 200 to 10000. Source: **(ours)**.
   */
  least_height_px: number;
  /**
   * Where the window is smaller: keep the answers with a mark, or do not begin. Allowed: "flag" or "refuse". Source: **(ours)**.
   */
  if_smaller: "flag" | "refuse";
  /**
   * Whether the pages fill the screen. Allowed: true or false. Source: **(ours)**.
   */
  full_screen: boolean;
  /**
   * Where they do not fill it: keep the answers with a mark, or do not begin. Allowed: "flag" or "refuse". Source: **(ours)**.
   */
  if_not_full_screen: "flag" | "refuse";
  /**
   * Whether the screen is measured with a bank card, so that sizes are in mm. Allowed: true or false. Source: **(ours)**.
   */
  card: boolean;
  /**
   * Where the size of a millimetre is not known: keep the answers with a mark, or do not begin. Allowed: "flag" or "refuse". Source: **(ours)**.
   */
  if_no_card: "flag" | "refuse";
  /**
   * Whether the viewing distance is asked for: by the blind spot, or typed in. Allowed: true or false. Source: **(ours)**.
   */
  distance: boolean;
  /**
   * The least viewing distance that passes. Allowed: 50 to 10000 mm. Source: **(ours)**; nearer than this few adults see sharply (Duane 1922).
   */
  least_distance_mm: number;
  /**
   * The greatest viewing distance that passes. Allowed: 50 to 10000 mm. Source: **(ours)**; farther away nobody reaches keys or mouse.
   */
  most_distance_mm: number;
  /**
   * Where the viewing distance is not known or does not pass: keep the answers with a mark, or do not begin. Allowed: "flag" or "refuse". Source: **(ours)**.
   */
  if_no_distance: "flag" | "refuse";
  /**
   * Whether gamma and the darkest step that can be seen are found by eye. Allowed: true or false. Source: **(ours)**.
   */
  levels: boolean;
  /**
   * The least gamma that passes. Allowed: 0.5 to 5. Source: **(ours)**.
   */
  least_gamma: number;
  /**
   * The greatest gamma that passes. Allowed: 0.5 to 5. Source: **(ours)**.
   */
  most_gamma: number;
  /**
   * The greatest first step above black that passes, of 255. Allowed: 1 to 255. Source: **(ours)**.
   */
  darkest_step: number;
  /**
   * Where gamma or the darkest step does not pass, or was not found: keep the answers with a mark, or do not begin. Allowed: "flag" or "refuse". Source: **(ours)**.
   */
  if_levels: "flag" | "refuse";
  /**
   * Where the browser says that the screen shows less than sRGB: keep the answers with a mark, or do not begin. Allowed: "flag" or "refuse". Source: **(ours)**.
   */
  if_small_gamut: "flag" | "refuse";
  /**
   * Which tests of the eyes are made, on plates of ours; no diagnosis. Allowed: "contrast", "colour" or both, each once. Source: **(ours)**.
   */
  vision: ("contrast" | "colour")[];
  /**
   * The share of plates read right that passes. Allowed: 0 to 1. Source: **(ours)**.
   */
  least_right: number;
  /**
   * Where fewer plates are read right, or none were shown: keep the answers with a mark, or do not begin. Allowed: "flag" or "refuse". Source: **(ours)**.
   */
  if_vision: "flag" | "refuse";
}
/**
 * What a screen check was found to be.
 */
export interface ScreenTold {
  flags: (
    | "small-window"
    | "not-full-screen"
    | "no-card"
    | "no-distance"
    | "distance"
    | "no-levels"
    | "gamma"
    | "darkest-step"
    | "small-gamut"
    | "contrast-vision"
    | "colour-vision"
  )[];
  refused: boolean;
}
/**
 * Training, breaks and pace.
 */
export interface Sitting {
  /**
   * How many pairs are shown first, to learn how it goes; their answers do not count. Allowed: 0 to 100. Source: **(ours)**.
   */
  training: number;
  /**
   * After how many trials there is a break; 0 for none. Allowed: 0 to 1000. Source: **(ours)**.
   */
  break_every: number;
  /**
   * How long a plain page of the pictures' grey is looked at after a break and on coming back, before the next pair; 0 for not at all. Allowed: 0 to 600 s. Source: Fairchild and Reniff 1995, 90 % of chromatic adaptation within 60 s.
   */
  adaptation_s: number;
  /**
   * How long a pair is on the screen before an answer is taken. Allowed: 0 to 60000 ms. Source: **(ours)**.
   */
  minimum_viewing_ms: number;
  /**
   * Whether "no difference" may be answered. Allowed: true or false. Source: **(ours)**.
   */
  ties: boolean;
}
/**
 * Where one participant is. Trials and pictures are there once they have consented.
 *
 * sitting: its name, which no other sitting gets, whatever becomes of token or number.
 */
export interface SittingTold {
  sitting: string;
  number: number;
  language: "en" | "ja";
  consented: boolean;
  screened: boolean;
  screen_flags: string[];
  refused: boolean;
  finished: boolean;
  ending: EndingTold | null;
  answered: number;
  groups_notes: Words[];
  trials: TrialTold[];
  pictures: {
    [k: string]: PictureTold;
  };
}
/**
 * A question about two pictures; never what is on them or why they are shown.
 */
export interface TrialTold {
  trial: number;
  question: string;
  left: string;
  right: string;
  training: boolean;
  break_before: boolean;
}
/**
 * A study to somebody who has not entered. `token` is fresh: it becomes theirs by entering.
 *
 * parameters: of the page's address, which are kept with whoever comes by it.
 */
export interface StudyTold {
  name: string;
  purpose: "study" | "demo";
  state: "open" | "paused" | "closed";
  registration: "open" | "invited";
  languages: ("en" | "ja")[];
  consent: Words;
  instructions: Words;
  questions: QuestionTold[];
  groups: GroupTold[];
  parameters: string[];
  sitting: Sitting;
  background_code: number;
  screen: Screen;
  token: string;
}
/**
 * Why there is no scale yet.
 */
export interface TooFew {
  problem: string;
}
/**
 * Who is logged in, and what each change must carry in X-CSRF-Token.
 */
export interface WhoTold {
  name: string;
  csrf: string;
}
/**
 * What each route takes and tells.
 */
export interface Routes {
  /**
   * Answer a trial. The receipt says that it is on the disk; the same again is welcome.
   */
  "PUT /api/answers/{trial}": {
    body: Answering;
    told: ReceiptTold;
  };
  /**
   * What the study is about, to whoever has not entered.
   */
  "GET /api/study": {
    body: undefined;
    told: StudyTold;
  };
  /**
   * Enter with a fresh token or an invitation's; the same token again is the same person.
   */
  "POST /api/enter": {
    body: Entering;
    told: SittingTold;
  };
  /**
   * Where the participant is, to begin or to go on.
   */
  "GET /api/sitting": {
    body: undefined;
    told: SittingTold;
  };
  /**
   * The participant agrees; no answer is taken before.
   */
  "POST /api/consent": {
    body: undefined;
    told: undefined;
  };
  /**
   * What the screen is like; the last check counts.
   */
  "POST /api/screen": {
    body: Checking;
    told: ScreenTold;
  };
  /**
   * Every trial is answered, which the server knows by the last answer; twice does no harm.
   */
  "POST /api/finish": {
    body: undefined;
    told: undefined;
  };
  /**
   * The participant does not want their answers to be counted.
   */
  "POST /api/withdraw": {
    body: undefined;
    told: undefined;
  };
  /**
   * A picture of the participant's own trials, once they have consented.
   */
  "GET /api/pictures/{sha256}": {
    body: undefined;
    told: Blob;
  };
  /**
   * Log in. Five tries a minute from one address, ten in fifteen minutes for one name.
   */
  "POST /lab/api/login": {
    body: LoggingIn;
    told: WhoTold;
  };
  /**
   * Who is logged in, after a page was loaded again.
   */
  "GET /lab/api/me": {
    body: undefined;
    told: WhoTold;
  };
  /**
   * Log out: the cookie is worthless from now on.
   */
  "POST /lab/api/logout": {
    body: undefined;
    told: undefined;
  };
  /**
   * Who, how far, how long; and what is noticed about whom, as far as that is worked out.
   */
  "GET /lab/api/progress": {
    body: undefined;
    told: ProgressTold;
  };
  /**
   * Open, pause or close the study.
   */
  "POST /lab/api/state": {
    body: Opening;
    told: undefined;
  };
  /**
   * Let anybody enter, or invited people alone.
   */
  "POST /lab/api/registration": {
    body: Registering;
    told: undefined;
  };
  /**
   * All invitations, without their links, which were told once.
   */
  "GET /lab/api/invitations": {
    body: undefined;
    told: InvitationTold[];
  };
  /**
   * Make invitations. The token stands behind #, which browsers send to no server.
   */
  "POST /lab/api/invitations": {
    body: Inviting;
    told: LinksTold;
  };
  /**
   * Let nobody enter by it any more.
   */
  "POST /lab/api/invitations/{invitation}/revoke": {
    body: undefined;
    told: undefined;
  };
  /**
   * Mark somebody's answers as not to be counted.
   */
  "POST /lab/api/people/{number}/exclude": {
    body: Excluding;
    told: undefined;
  };
  /**
   * Count them after all.
   */
  "POST /lab/api/people/{number}/readmit": {
    body: undefined;
    told: undefined;
  };
  /**
   * Make somebody's token worthless.
   */
  "POST /lab/api/people/{number}/revoke": {
    body: undefined;
    told: undefined;
  };
  /**
   * A picture of the study.
   */
  "GET /lab/api/pictures/{sha256}": {
    body: undefined;
    told: Blob;
  };
  /**
   * The end of the study's audit log.
   */
  "GET /lab/api/events": {
    body: undefined;
    told: EventTold[];
  };
  /**
   * The scale so far, or why there is none yet.
   */
  "GET /lab/api/scale": {
    body: undefined;
    told: ScaleTold | TooFew;
  };
  /**
   * The report as one page, to be kept.
   */
  "GET /lab/api/report": {
    body: undefined;
    told: Blob;
  };
  /**
   * All answers, the excluded, simulated and erased ones marked; bom: as Excel wants it.
   */
  "GET /lab/api/answers.csv": {
    body: undefined;
    told: Blob;
  };
  /**
   * Everyone who has entered, with their flags, also who never answered.
   */
  "GET /lab/api/people.csv": {
    body: undefined;
    told: Blob;
  };
}
