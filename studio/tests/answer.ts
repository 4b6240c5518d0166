import type { Answer, Chosen } from "../src/participant/api";

/** An answer to a trial. */
export function answer(trial: number, chosen: Chosen = "left"): Answer {
  return {
    trial,
    chosen,
    response_ms: 1840.5,
    shown_at: "2026-03-01T09:30:00.000Z",
    answered_at: "2026-03-01T09:30:01.840Z",
    flags: {},
    simulated: false,
  };
}
