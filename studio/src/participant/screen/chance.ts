/** Chance that can be repeated: the same seed, the same numbers. */

/** Numbers from 0 to below 1, by Marsaglia's xorshift of 32 bits, after a few idle rounds. */
export function chance(seed: number): () => number {
  let state = (seed * 2654435761 + 97) >>> 0 || 1;
  const next = () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 2 ** 32;
  };
  for (let round = 0; round < 8; round += 1) next();
  return next;
}

/** One of some things. */
export function oneOf<T>(things: readonly [T, ...T[]], next: () => number): T {
  return things[Math.floor(next() * things.length)] ?? things[0];
}
