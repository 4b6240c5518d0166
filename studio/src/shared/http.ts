/** Requests to the study's server, and what it says when it refuses. */

/** A refusal, or no answer at all: then `status` is 0. */
export class Problem extends Error {
  constructor(
    message: string,
    readonly kind: string,
    readonly status: number,
    readonly retryAfterMs = 0,
  ) {
    super(message);
  }

  /** Whether the same request may yet succeed: no network, a busy server, or one that failed. */
  get passes(): boolean {
    return [0, 408, 429].includes(this.status) || this.status >= 500;
  }
}

export interface Request {
  method?: "GET" | "POST" | "PUT";
  body?: unknown;
  headers?: Record<string, string>;
  /** After how long a request without an answer counts as failed. */
  patience_ms?: number;
}

/** The answer to a request; throws `Problem` for anything but 2xx. */
export async function send(path: string, request: Request = {}): Promise<Response> {
  const { method = "GET", body, headers = {}, patience_ms = 15_000 } = request;
  const asked: RequestInit = { method, headers, signal: AbortSignal.timeout(patience_ms) };
  if (body !== undefined) {
    asked.body = JSON.stringify(body);
    asked.headers = { ...headers, "Content-Type": "application/json" };
  }
  let response: Response;
  try {
    response = await fetch(path, asked);
  } catch (reason) {
    throw new Problem(String(reason), "network", 0);
  }
  if (!response.ok) throw await refusal(response);
  return response;
}

/** The JSON that a request brings; nothing for 204. */
export async function ask<T>(path: string, request: Request = {}): Promise<T> {
  const response = await send(path, request);
  if (response.status === 204) return undefined as T;
  try {
    return (await response.json()) as T;
  } catch (reason) {
    throw new Problem(String(reason), "network", 0); // cut off in the middle
  }
}

async function refusal(response: Response): Promise<Problem> {
  const told = (await response.json().catch(() => ({}))) as { problem?: string; kind?: string };
  const wait_s = Number(response.headers.get("Retry-After") ?? 0);
  return new Problem(
    told.problem ?? response.statusText,
    told.kind ?? "unknown",
    response.status,
    Number.isFinite(wait_s) ? wait_s * 1000 : 0,
  );
}
