// Browsers run WebAssembly first in a slow tier: the stages of a stroke are run here a few times while nobody waits, so that the
// first stroke meets fast code.
import type { State } from './api.ts';
import type { Engine } from './engine.ts';
import { kWorthSharing } from './solids/helper.ts';

/** Rounds after which what matters has been called often enough. */
const kRounds = 12;
/** A round is begun only in idle time of at least this many milliseconds; without such a measure, this long after the last one. */
const kSlice = 10;
const kPause = 120;
/** After so long without a change, ms, what is likely to be stuck together is put together. */
const kRest = 1000;
/** What `performance` holds when all rounds have run. */
export const kWarmMark = 'spineloft-warm';

function whenIdle(work: (deadline?: IdleDeadline) => void): void {
  if (typeof requestIdleCallback === 'function') requestIdleCallback(work);
  else setTimeout(() => work(), kPause);
}

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
  const later = () => whenIdle(round);
  requestAnimationFrame(() => setTimeout(later, kPause));
}

type Seen = Pick<State, 'picked' | 'undo'> & { parts: Pick<State['parts'][number], 'triangles'>[] };

/** Whether a step was taken between two looks; a model that is opened brings its own steps, and all its parts at once. */
export function wasWorkedAt(before: Seen, now: Seen): boolean {
  return before.parts.length > 0 && now.undo === before.undo + 1;
}

/**
 * How many workers of solids are likely to be needed soon: one as soon as there is something to stick together in a model
 * that is worked at, two when a large union is being picked.
 */
export function solidWorkersFor({ parts, picked }: Seen, isWorkedAt: boolean): 0 | 1 | 2 {
  if (parts.length < 2 || (!isWorkedAt && picked.length === 0)) return 0;
  return picked.length > 1 &&
    parts.length > 3 &&
    parts.reduce((sum, { triangles }) => sum + triangles, 0) >= kWorthSharing
    ? 2
    : 1;
}

/** Has them started, and made quick, in idle moments. */
export class SolidWarmUp {
  private workers = 0;
  private before: Seen | null = null;
  private isWorkedAt = false;
  private rest: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly engine: Pick<Engine, 'isIdle' | 'prepareSolids' | 'solver'>) {}

  see(state: State): void {
    this.isWorkedAt ||= this.before !== null && wasWorkedAt(this.before, state);
    this.before = state;
    const before = this.workers,
      workers = (this.workers = solidWorkersFor(state, this.isWorkedAt));
    if (this.isWorkedAt && workers > 0) this.prepare();
    if (workers <= before) return;
    whenIdle(() => {
      if (this.engine.isIdle()) this.engine.solver?.warm(workers > 1);
      else this.workers = before;
    });
  }

  /** Once the hand rests, and the page is seen: a page in the background does nothing unasked. */
  private prepare(): void {
    clearTimeout(this.rest);
    this.rest = setTimeout(
      () =>
        whenIdle(() => {
          if (document.visibilityState !== 'visible') return;
          if (this.engine.isIdle()) this.engine.prepareSolids();
          else this.prepare();
        }),
      kRest,
    );
  }
}
