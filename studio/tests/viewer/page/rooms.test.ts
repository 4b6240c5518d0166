import { expect, test } from "vitest";

const ROOMS = ["specs", "light", "words", "state", "panels"];

const files = import.meta.glob<string>("../../../src/viewer/*/**/*.{ts,tsx}", {
  query: "?raw",
  import: "default",
  eager: true,
});

test("a room of the viewer imports only rooms before it", () => {
  const wrong: string[] = [];
  for (const [path, text] of Object.entries(files)) {
    const room = ROOMS.findIndex((name) => path.includes(`/viewer/${name}/`));
    expect(room, path).toBeGreaterThanOrEqual(0);
    for (const [, from] of text.matchAll(/from "([^"]+)"/g)) {
      const other = ROOMS.findIndex((name) => from?.includes(`../${name}/`));
      if (other > room) wrong.push(`${path} imports ${from}`);
    }
  }
  expect(wrong).toEqual([]);
});
