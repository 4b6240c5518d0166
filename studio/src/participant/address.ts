/** What the page's address says of who comes: the parameters that the study keeps, and no others. */

/** The declared parameters that have a value; of one given twice the first. */
export function parametersOf(search: string, declared: string[]): Record<string, string> {
  const given = new URLSearchParams(search);
  const found = declared.map((name) => [name, given.get(name)?.trim() ?? ""] as const);
  return Object.fromEntries(found.filter(([, value]) => value !== ""));
}

/** What the server counts as hidden; joiners within Persian words and emoji are none. */
const HIDDEN = /[^\P{C}\u200c\u200d]|[\p{Zl}\p{Zp}]/u;
const LONGEST = 200;

/** Whether the server will keep them; a link that was cut off or patched up says nothing. */
export function canBeKept(parameters: Record<string, string>): boolean {
  return Object.values(parameters).every(
    (value) => [...value].length <= LONGEST && !HIDDEN.test(value),
  );
}

/** At least one name. */
export type Places = [string, ...string[]];

/**
 * Under which names this browser keeps the token of whoever came by such an address, the surest
 * first. Two people who share a computer come by two; who comes back without any finds the last.
 */
export function placesOf(study: string, parameters: Record<string, string>): Places {
  const told = new URLSearchParams(parameters).toString();
  return told === "" ? [study] : [`${study}?${told}`, study];
}
