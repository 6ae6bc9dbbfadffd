// Which tab a model belongs to: only one writes it. Web Locks hold it for as long as the tab lives; where
// they are missing, a sign of life every few seconds does.
import type { ModelStore } from './store.ts';

export interface Claims {
  /** True when the model is this tab's now; false: another tab has it. */
  claim(id: string): Promise<boolean>;
  /** Takes it from the tab that has it, which is told and gets a moment to finish its writing. */
  take(id: string): Promise<void>;
  release(id: string): void;
  /** Ids of the models that any tab has. */
  all(): Promise<string[]>;
}

/** What the owner of the claims wants to know. */
export interface ClaimEvents {
  /** Another tab asks for the model: finish what is being written. */
  finish(id: string): Promise<void>;
  /** Another tab has it now. */
  lost(id: string): void;
}

const kLockPrefix = 'spineloft-model-';
const kBeatMs = 2000,
  kStaleMs = 7000,
  kPatienceMs = 1500;

type Message = { take: string; from: string };

/** Talks to the page's other tabs; without BroadcastChannel nobody hears. */
class Neighbours {
  private readonly channel = typeof BroadcastChannel === 'function' ? new BroadcastChannel('spineloft-models') : null;

  constructor(
    private readonly tab: string,
    private readonly asked: (id: string) => void,
  ) {
    this.channel?.addEventListener('message', (event: MessageEvent<Message>) => {
      if (event.data.from !== this.tab && typeof event.data.take === 'string') this.asked(event.data.take);
    });
  }

  ask(id: string): void {
    this.channel?.postMessage({ take: id, from: this.tab } satisfies Message);
  }
}

class LockClaims implements Claims {
  private readonly held = new Map<string, () => void>();
  private readonly neighbours: Neighbours;

  constructor(
    tab: string,
    private readonly events: ClaimEvents,
  ) {
    this.neighbours = new Neighbours(tab, (id) => void this.giveUp(id));
  }

  claim(id: string): Promise<boolean> {
    if (this.held.has(id)) return Promise.resolve(true);
    return this.request(id, { ifAvailable: true });
  }

  async take(id: string): Promise<void> {
    if (this.held.has(id)) return;
    this.neighbours.ask(id);
    const patience = new AbortController();
    const timer = setTimeout(() => patience.abort(), kPatienceMs);
    const given = await this.request(id, { signal: patience.signal }).catch(() => false);
    clearTimeout(timer);
    if (!given) await this.request(id, { steal: true });
  }

  release(id: string): void {
    this.held.get(id)?.();
    this.held.delete(id);
  }

  async all(): Promise<string[]> {
    const { held = [] } = await navigator.locks.query();
    return held.flatMap(({ name }) => (name?.startsWith(kLockPrefix) ? [name.slice(kLockPrefix.length)] : []));
  }

  private async giveUp(id: string): Promise<void> {
    if (!this.held.has(id)) return;
    await this.events.finish(id);
    if (!this.held.has(id)) return;
    this.release(id);
    this.events.lost(id);
  }

  /** Resolves once it is known whether the lock is ours; it stays ours until `release`. */
  private request(id: string, options: LockOptions): Promise<boolean> {
    return new Promise((resolve, reject) => {
      navigator.locks
        .request(kLockPrefix + id, options, (lock) => {
          resolve(lock !== null);
          return lock === null ? undefined : new Promise<void>((done) => this.held.set(id, done));
        })
        .catch((thrown: unknown) => {
          // Stolen by a tab that did not wait, or never given.
          if (this.held.delete(id)) this.events.lost(id);
          reject(thrown);
        });
    });
  }
}

class BeatClaims implements Claims {
  private readonly held = new Set<string>();
  private readonly neighbours: Neighbours;
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor(
    private readonly store: ModelStore,
    private readonly tab: string,
    private readonly events: ClaimEvents,
  ) {
    this.neighbours = new Neighbours(tab, (id) => void this.giveUp(id));
  }

  async claim(id: string): Promise<boolean> {
    const now = Date.now();
    const free = await this.store.hold(id, this.tab, now, now - kStaleMs);
    if (free) this.keep(id);
    return free;
  }

  async take(id: string): Promise<void> {
    this.neighbours.ask(id);
    for (const end = Date.now() + kPatienceMs; Date.now() < end;) {
      if (await this.claim(id)) return;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
    await this.store.hold(id, this.tab, Date.now(), Infinity);
    this.keep(id);
  }

  release(id: string): void {
    if (!this.held.delete(id)) return;
    if (this.held.size === 0) clearInterval(this.timer);
    void this.store.letGo(id, this.tab).catch(() => undefined);
  }

  all(): Promise<string[]> {
    return this.store.held(Date.now() - kStaleMs);
  }

  private keep(id: string): void {
    if (this.held.size === 0) this.timer = setInterval(() => void this.beat(), kBeatMs);
    this.held.add(id);
  }

  private async giveUp(id: string): Promise<void> {
    if (!this.held.has(id)) return;
    await this.events.finish(id);
    this.release(id);
    this.events.lost(id);
  }

  private async beat(): Promise<void> {
    const now = Date.now();
    for (const id of this.held) {
      // While storage does not answer, nobody else can take it either.
      const mine = await this.store.hold(id, this.tab, now, now - kStaleMs).catch(() => true);
      if (mine || !this.held.delete(id)) continue;
      this.events.lost(id);
    }
    if (this.held.size === 0) clearInterval(this.timer);
  }
}

/** The best that this browser has. */
export function makeClaims(store: ModelStore, tab: string, events: ClaimEvents): Claims {
  const hasLocks = typeof navigator === 'object' && 'locks' in navigator && navigator.locks !== undefined;
  return hasLocks ? new LockClaims(tab, events) : new BeatClaims(store, tab, events);
}
