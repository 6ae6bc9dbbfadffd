/** How much longer random tests go on than in `npm test`. */
export const kRounds = Number(process.env.SPINELOFT_ROUNDS ?? 1);

/**
 * Of the variants of one test (hands, sizes, pictures): those with these numbers in `npm test`, all of them in
 * `npm run test:all`.
 */
export const sample = (all, ...numbers) => (kRounds > 1 ? all : numbers.map((number) => all[number]));
