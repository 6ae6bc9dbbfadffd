// Sharing the processors out: a job takes as many lanes as it keeps processors busy, and waits until they are free.
import { availableParallelism } from 'node:os';

/** Lanes of one processor. A job that often waits takes fewer than one processor has. */
export const kLanesPerProcessor = 3;

/** The lanes of some processors. Jobs begin in the order in which they came: one that wants all is never overtaken. */
export class Lanes {
  constructor(processors = availableParallelism()) {
    this.processors = processors;
    this.count = kLanesPerProcessor * processors;
    this.free = this.count;
    this.waiting = [];
  }

  /** Runs `work` on `wanted` lanes (at most all of them) and resolves to what it returns. */
  async run(work, wanted = kLanesPerProcessor) {
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
