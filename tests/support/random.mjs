/** Random numbers in [0, 1), the same ones for the same seed: a linear congruential generator (Numerical Recipes). It stands alone: a page may be given its text. */
export function seeded(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}
