/** What the page's address says of who comes: the parameters that the study keeps, and no others. */

/** The declared parameters that have a value; of one given twice the first. */
export function parametersOf(search: string, declared: string[]): Record<string, string> {
  const given = new URLSearchParams(search);
  const found = declared.map((name) => [name, given.get(name)?.trim() ?? ""] as const);
  return Object.fromEntries(found.filter(([, value]) => value !== ""));
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
