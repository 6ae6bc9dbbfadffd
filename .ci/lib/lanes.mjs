// Sharing the processors out: a job takes as many lanes as it keeps processors busy, and waits until they are free.
import { availableParallelism } from 'node:os';

/** `count` lanes. Jobs begin in the order in which they were asked for: one that wants all lanes is never overtaken. */
export class Lanes {
  constructor(count = availableParallelism()) {
    this.count = count;
    this.free = count;
    this.waiting = [];
  }

  /** Runs `work` on `wanted` lanes (at most all of them) and resolves to what it returns. */
  async run(work, wanted = 1) {
    const taken = Math.min(wanted, this.count);
    await new Promise((resolve) => {
      this.waiting.push({ taken, resolve });
      this.#begin();
    });
    try {
      return await work();
    } finally {
      this.free += taken;
      this.#begin();
    }
  }

  /** Runs `work` on all lanes. */
  alone(work) {
    return this.run(work, this.count);
  }

  #begin() {
    while (this.waiting.length && this.waiting[0].taken <= this.free) {
      const { taken, resolve } = this.waiting.shift();
      this.free -= taken;
      resolve();
    }
  }
}
