// Browsers run WebAssembly first in a slow tier: the stages of a stroke are run here a few times while nobody waits, so that the
// first stroke meets fast code.
import type { Engine } from './engine.ts';

/** Rounds after which what matters has been called often enough. */
const kRounds = 12;
/** A round is begun only in idle time of at least this many milliseconds; without such a measure, this long after the last one. */
const kSlice = 10;
const kPause = 120;
/** What `performance` holds when all rounds have run. */
export const kWarmMark = 'spineloft-warm';

/** Begins after the page has been drawn, and goes on only while the page and its engine have nothing else to do. */
export function warmUpWhenIdle(engine: Engine): void {
  let left = kRounds;
  const round = (deadline?: IdleDeadline) => {
    const room = deadline === undefined || deadline.timeRemaining() >= kSlice;
    if (room && engine.isIdle()) {
      left -= 1;
      if (!engine.warmUp()) left = 0;
    }
    if (left > 0) later();
    else performance.mark(kWarmMark);
  };
  const later = () => {
    if (typeof requestIdleCallback === 'function') requestIdleCallback(round);
    else setTimeout(() => round(), kPause);
  };
  requestAnimationFrame(() => setTimeout(later, kPause));
}
