import { afterEach, expect, it, vi } from "vitest";

import { addressOf, ask, bring } from "../src/shared/http";

afterEach(() => vi.unstubAllGlobals());

/** What is sent, where every request is answered alike. */
function answered(body: string | null, init: ResponseInit = {}) {
  const fetched = vi.fn((_path: string, _asked: RequestInit) =>
    Promise.resolve(new Response(body, init)),
  );
  vi.stubGlobal("fetch", fetched);
  return fetched;
}

it("puts places into a path so that none leads out of it", () => {
  const route = "GET /lab/api/pictures/{sha256}";
  expect(addressOf(route, { places: { sha256: "../me?a#b" } })).toBe(
    "/lab/api/pictures/..%2Fme%3Fa%23b",
  );
});

it("sends a query as the route takes it", () => {
  const query = { question: "a & b", simulated: true };
  expect(addressOf("GET /lab/api/scale", { query })).toBe(
    "/lab/api/scale?question=a+%26+b&simulated=true",
  );
});

it("asks by method and path, with a body in JSON for every change", async () => {
  const fetched = answered(null, { status: 204 });
  await ask("POST /lab/api/state", { state: "paused" });
  await ask("POST /api/consent", undefined);
  expect(fetched.mock.calls.map(([path, { method, body }]) => [path, method, body])).toEqual([
    ["/lab/api/state", "POST", '{"state":"paused"}'],
    ["/api/consent", "POST", "{}"],
  ]);
});

it("takes another site's page in place of an answer for a network that is cut", async () => {
  answered("<p>Log in to this hotel's network</p>", { headers: { "Content-Type": "text/html" } });
  await expect(ask("GET /api/sitting", undefined)).rejects.toMatchObject({
    kind: "network",
    passes: true,
  });
});

it("brings a file whatever its kind", async () => {
  answered("a,b", { headers: { "Content-Type": "text/csv" } });
  expect(await (await bring("GET /lab/api/answers.csv")).text()).toBe("a,b");
});
