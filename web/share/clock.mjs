// The time by which things expire. A clock that jumps, by a wrong setting or after a sleep, is believed only when it has
// stayed where it jumped to: a wrong date for a moment removes nothing.
import { kLimits } from './limits.mjs';

/** A smaller difference is the drift of a clock. */
const kDriftMs = 5000;

export class Clock {
  /** `wall` and `steady` give milliseconds: since 1970, and since any moment without jumps. */
  constructor({ wall = Date.now, steady = () => performance.now(), patience = kLimits.clockPatienceMs } = {}) {
    this.wall = wall;
    this.steady = steady;
    this.patience = patience;
    this.base = wall() - steady();
    this.offSince = null;
    this.offBase = 0;
  }

  /** Milliseconds since 1970, whole. */
  now() {
    const steady = this.steady();
    const base = this.wall() - steady;
    if (Math.abs(base - this.base) <= kDriftMs) {
      this.base = base;
      this.offSince = null;
    } else if (this.offSince === null || Math.abs(base - this.offBase) > kDriftMs) {
      this.offSince = steady;
      this.offBase = base;
    } else if (steady - this.offSince >= this.patience) {
      this.base = base;
      this.offSince = null;
    }
    return Math.round(this.base + steady);
  }
}
