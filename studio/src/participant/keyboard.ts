/** Whether there may be a keyboard, so that keys are worth a word. */

/**
 * False on telephones and tablets without a mouse or a trackpad: a browser does not tell of
 * keyboards, but whoever has one beside a touch screen mostly has a pointer too.
 */
export function mayHaveKeys(): boolean {
  const touch = matchMedia("(pointer: coarse)").matches;
  return !touch || matchMedia("(any-hover: hover) and (any-pointer: fine)").matches;
}
