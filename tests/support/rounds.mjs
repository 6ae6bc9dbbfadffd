/** How much longer random tests go on than in `npm test`. */
export const kRounds = Number(process.env.SPINELOFT_ROUNDS ?? 1);
