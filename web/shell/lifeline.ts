// A worker that the browser ends, for want of memory say, tells nobody. So it holds a lock for as long as it lives,
// and whoever waits for the lock hears of its end. Without Web Locks nothing is heard.

/** In the worker: holds its lock; `alive` is called once it has it. */
export function hold(name: string, alive: () => void): void {
  if (!name || !('locks' in navigator)) return;
  void navigator.locks.request(name, () => {
    alive();
    return new Promise<void>(() => {});
  });
}

/** On the page, once the worker is alive: calls `ended` when it lives no more. */
export function waitForEnd(name: string, ended: () => void): void {
  if (!('locks' in navigator)) return;
  void navigator.locks.request(name, () => ended());
}
