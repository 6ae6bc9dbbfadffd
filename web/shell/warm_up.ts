// Browsers run WebAssembly first in a slow tier: the stages of a stroke are run here a few times while nobody waits, so that the
// first stroke meets fast code.
import type { Engine } from './engine.ts';
import type { ShellView } from './shell_view.ts';

/** Rounds after which what matters has been called often enough. */
const kRounds = 12;
/** A round is begun only in idle time of at least this many milliseconds; without such a measure, this long after the last one. */
const kSlice = 10;
const kPause = 120;
/** What `performance` holds when all rounds have run. */
export const kWarmMark = 'spineloft-warm';

function whenIdle(work: (deadline?: IdleDeadline) => void): void {
  if (typeof requestIdleCallback === 'function') requestIdleCallback(work);
  else setTimeout(() => work(), kPause);
}

/**
 * Begins after the page has been drawn, unless the mark is set already, and goes on only while the page and its engine have
 * nothing else to do.
 */
export function warmUpWhenIdle(engine: Engine): void {
  if (performance.getEntriesByName(kWarmMark).length > 0) return;
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
  const later = () => whenIdle(round);
  requestAnimationFrame(() => setTimeout(later, kPause));
}

/** Between tries to fetch what is missing of the engine. */
const kRetry = 3000;

/** Fetches the rest of the engine in an idle moment, and again until it is there. */
export function fetchRest(engine: Engine): void {
  const fetchIt = () => void engine.whole().catch(() => setTimeout(fetchIt, kRetry));
  whenIdle(fetchIt);
}

type Seen = Pick<ShellView, 'parts' | 'picked' | 'undo'>;

/**
 * Whether a solid is likely to be asked for soon: parts are ticked, or a step was taken in a model of two parts. A model
 * that is only opened and looked at brings its own steps, and all its parts at once.
 */
export function isSolidLikely(before: Seen | null, { parts, picked, undo }: Seen): boolean {
  if (parts < 2) return false;
  return picked > 0 || (before !== null && before.parts > 0 && undo === before.undo + 1);
}

/** Starts the worker of solids in an idle moment. */
export function startSolver(engine: Engine): void {
  whenIdle(() => engine.solver?.start());
}

const cutsOut = (seen: Pick<ShellView, 'tool' | 'picture'> | null): boolean =>
  seen !== null && seen.picture !== null && (seen.tool === 'puff' || seen.tool === 'sheet');

/** Whether a cut-out has become likely: a tool is taken in hand whose tap on a picture cuts out. */
export function isCutOutLikely(before: Parameters<typeof cutsOut>[0], now: Parameters<typeof cutsOut>[0]): boolean {
  return cutsOut(now) && !cutsOut(before);
}

/** Starts the worker that cuts out in an idle moment. */
export function startCutter(engine: Engine): void {
  whenIdle(() => engine.cutter?.start());
}
