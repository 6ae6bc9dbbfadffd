// What the workers of the browsers that this process started have used of the processor: on a machine that others use,
// too, the steadier number. Linux; elsewhere nothing is found.
import { readdirSync, readFileSync } from 'node:fs';

const numbers = (folder) => readdirSync(folder).filter((name) => /^\d+$/.test(name));
const textOf = (file) => readFileSync(file, 'utf8');

/** Of every process its parent. */
function parents() {
  return new Map(
    numbers('/proc').flatMap((pid) => {
      try {
        // After the name, which may hold anything: state, parent.
        return [[pid, textOf(`/proc/${pid}/stat`).split(') ').at(-1).split(' ')[1]]];
      } catch {
        return []; // it has ended
      }
    }),
  );
}

function isBelow(parent, pid, root) {
  for (let at = pid; at !== undefined && at !== '0'; at = parent.get(at)) if (at === root) return true;
  return false;
}

/** Milliseconds by thread. */
export function workerTimes(root = process.pid) {
  const times = {};
  if (process.platform !== 'linux') return times;
  const parent = parents();
  for (const pid of parent.keys()) {
    if (!isBelow(parent, pid, String(root))) continue;
    try {
      for (const thread of numbers(`/proc/${pid}/task`)) {
        const folder = `/proc/${pid}/task/${thread}`;
        if (textOf(`${folder}/comm`).startsWith('DedicatedWorker'))
          times[thread] = Number(textOf(`${folder}/schedstat`).split(' ')[0]) / 1e6;
      }
    } catch {
      // It has ended.
    }
  }
  return times;
}

/** What the busiest of them used between two looks; null where that is not known. */
export function busiest(before, after) {
  const used = Object.entries(after).map(([thread, ms]) => ms - (before[thread] ?? 0));
  return used.length > 0 ? Math.max(...used) : null;
}
