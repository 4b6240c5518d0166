/** Requests to the study's server, and what it says when it refuses. */

import { fill } from "./language";
import type { Routes, Problem as Told } from "./wire";

/** A method and a path, as the server describes them. */
export type Route = keyof Routes;

/** Those routes that bring a file. */
export type FileRoute = { [R in Route]: Routes[R]["told"] extends Blob ? R : never }[Route];

/** A refusal, or no answer at all: then `status` is 0. */
export class Problem extends Error {
  constructor(
    message: string,
    readonly kind: Told["kind"] | "network" | "unknown",
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

/** What a request has besides its body. */
export interface Options {
  /** What stands in the path's braces. */
  places?: Record<string, string | number>;
  query?: Record<string, string | number | boolean>;
  headers?: Record<string, string>;
  /** After how long a request without an answer counts as failed. */
  patience_ms?: number;
}

/** What a route tells in JSON; throws `Problem` for anything but 2xx. */
export async function ask<R extends Exclude<Route, FileRoute>>(
  route: R,
  body: Routes[R]["body"],
  options: Options = {},
): Promise<Routes[R]["told"]> {
  const response = await send(route, body, options);
  if (response.status === 204) return undefined as Routes[R]["told"];
  return whole(response.json());
}

/** The file that a route brings; throws `Problem` for anything but 2xx. */
export async function bring(route: FileRoute, options: Options = {}): Promise<Blob> {
  return whole((await send(route, undefined, options)).blob());
}

/** All of a response, which may be cut off in the middle. */
async function whole<T>(content: Promise<T>): Promise<T> {
  try {
    return await content;
  } catch (reason) {
    throw new Problem(String(reason), "network", 0);
  }
}

/** Where a route is. */
export function addressOf(route: Route, { places = {}, query = {} }: Options = {}): string {
  const path = fill(route.slice(route.indexOf(" ") + 1), encoded(places));
  const search = new URLSearchParams(encoded(query, String)).toString();
  return search === "" ? path : `${path}?${search}`;
}

function encoded(values: object, as: (text: string) => string = encodeURIComponent) {
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, as(`${value}`)]));
}

async function send(route: Route, body: unknown, options: Options): Promise<Response> {
  const { headers = {}, patience_ms = 15_000 } = options;
  const method = route.slice(0, route.indexOf(" "));
  const asked: RequestInit = { method, headers, signal: AbortSignal.timeout(patience_ms) };
  if (method !== "GET") {
    asked.body = JSON.stringify(body ?? {});
    asked.headers = { ...headers, "Content-Type": "application/json" };
  }
  let response: Response;
  try {
    response = await fetch(addressOf(route, options), asked);
  } catch (reason) {
    throw new Problem(String(reason), "network", 0);
  }
  if (!response.ok) throw await refusal(response);
  return response;
}

async function refusal(response: Response): Promise<Problem> {
  const told = (await response.json().catch(() => ({}))) as Partial<Told>;
  const wait_s = Number(response.headers.get("Retry-After") ?? 0);
  return new Problem(
    told.problem ?? response.statusText,
    told.kind ?? "unknown",
    response.status,
    Number.isFinite(wait_s) ? wait_s * 1000 : 0,
  );
}
