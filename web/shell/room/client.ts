// The share server as the page sees it (web/share): stored models and rooms. Everything is encrypted and decrypted here.
// Whatever is sent can be sent again: ids are chosen here, and the same twice is once.
import { keyOfWords, newId, newKey, newWords, seal, unseal } from './cipher.ts';
import { packMessage, unpackMessage } from './messages.ts';
import type { Message } from './messages.ts';
import { refusalSentence } from './refusals.ts';

/** A refusal of the server, or 'Offline' where it was not reached. */
export class ServerFailure extends Error {
  constructor(
    readonly code: string,
    message: string,
    /** Seconds after which it may go better; 0: it will not. */
    readonly retryAfter = 0,
  ) {
    super(message);
  }
}

interface Asked {
  method?: string;
  secret?: string | undefined;
  body?: Uint8Array;
  signal?: AbortSignal;
}

const kRetried = [423, 429, 500, 502, 503, 504, 507];

/** Where everybody finds the server: an address that ends with 'v1/'. */
export class ShareServer {
  constructor(private readonly address: string) {}

  async ask(path: string, { method = 'GET', secret, body, signal }: Asked = {}): Promise<Response> {
    const headers: Record<string, string> = {};
    if (secret) headers['Authorization'] = `Bearer ${secret}`;
    if (body) headers['Content-Type'] = 'application/octet-stream';
    const response = await fetch(this.address + path, {
      method,
      headers,
      credentials: 'omit',
      referrerPolicy: 'no-referrer',
      ...(body ? { body: body as BodyInit } : {}),
      ...(signal ? { signal } : {}),
    }).catch(() => {
      throw new ServerFailure('Offline', 'The server was not reached. Check the connection.', 2);
    });
    if (response.ok) return response;
    const { code = 'Failed' } = (await response.json().catch(() => ({}))) as { code?: string };
    const after = kRetried.includes(response.status) ? Number(response.headers.get('Retry-After') ?? 3) : 0;
    throw new ServerFailure(code, refusalSentence(code), after);
  }

  async bytes(path: string, asked?: Asked): Promise<Uint8Array> {
    return new Uint8Array(await (await this.ask(path, asked)).arrayBuffer());
  }

  // ---- stored models ----------------------------------------------------------------------------

  /** Stores a model for some days; `id.key` opens it, `secret` takes it back. */
  async storeModel(bytes: Uint8Array, days: number, as = newStoredModel()): Promise<StoredModel> {
    const body = seal(as.key, bytes, `model/${as.id}`);
    await this.ask(`models/${as.id}?days=${days}`, { method: 'PUT', secret: as.secret, body });
    return as;
  }

  async storedModel({ id, key }: { id: string; key: string }): Promise<Uint8Array> {
    const bytes = unseal(key, await this.bytes(`models/${id}`), `model/${id}`);
    if (!bytes) throw new ServerFailure('WrongKey', 'This link was changed on its way. Ask for it again.');
    return bytes;
  }

  async takeBack({ id, secret }: { id: string; secret: string }): Promise<void> {
    await this.ask(`models/${id}`, { method: 'DELETE', secret });
  }

  // ---- rooms ------------------------------------------------------------------------------------

  /** Opens a room; who has its `secret` is the teacher. */
  async openRoom(days: number): Promise<RoomKey> {
    const room = { id: newId(), key: newKey(), secret: newId() };
    await this.ask(`rooms/${room.id}?days=${days}`, { method: 'PUT', secret: room.secret });
    return room;
  }

  /** New join words for a room: those that it had lead nowhere any more. */
  async nameRoom(room: RoomKey): Promise<{ words: string[]; expires: number }> {
    const words = newWords();
    const { locator, key } = keyOfWords(words);
    const body = seal(key, new TextEncoder().encode(`${room.id}.${room.key}`), `words/${locator}`);
    const path = `rooms/${room.id}/words/${locator}`;
    const answer = await this.ask(path, { method: 'PUT', secret: room.secret, body });
    return { words, expires: ((await answer.json()) as { expires: number }).expires };
  }

  /** The room that join words lead to. */
  async findRoom(words: readonly string[]): Promise<{ id: string; key: string }> {
    const { locator, key } = keyOfWords(words);
    const opened = unseal(key, await this.bytes(`words/${locator}`), `words/${locator}`);
    const [id, roomKey] = opened ? new TextDecoder().decode(opened).split('.') : [];
    if (!id || !roomKey) throw new ServerFailure('NotThere', refusalSentence('NotThere'));
    return { id, key: roomKey };
  }
}

export interface StoredModel {
  id: string;
  key: string;
  secret: string;
}

export const newStoredModel = (): StoredModel => ({ id: newId(), key: newKey(), secret: newId() });

export interface RoomKey {
  id: string;
  key: string;
  /** Of the teacher; undefined for everybody else. */
  secret?: string | undefined;
}

/** A pupil's place in a room. */
export interface Seat {
  id: string;
  secret: string;
}

/** A post as the server lists it; `seat` is null for the teacher. */
export interface ListedPost {
  seq: number;
  post: string;
  seat: string | null;
  size: number;
  at: number;
}

export interface RoomState {
  frozen: boolean;
  hidden: string[];
}

export interface RoomListener {
  post(post: ListedPost): void;
  state(state: RoomState): void;
  /** The room is gone. */
  ended(): void;
  /** Whether events arrive. */
  connected(isConnected: boolean): void;
}

const place = (room: string, post: string, seat: string | null) => `room/${room}/${post}/${seat ?? 'teacher'}`;

/** A room as somebody in it sees it: as the teacher with the room's secret, as a pupil with a seat, else as a guest. */
export class Room {
  constructor(
    readonly server: ShareServer,
    readonly key: RoomKey,
    readonly seat: Seat | null,
  ) {}

  private get path(): string {
    return `rooms/${this.key.id}`;
  }

  private get secret(): string | undefined {
    return this.seat ? this.seat.secret : this.key.secret;
  }

  /** Takes the seat; again, it is the same one. Its number in the room. */
  async sit(): Promise<number> {
    const answer = await this.server.ask(`${this.path}/seats/${this.seat!.id}`, { method: 'PUT', ...this.own() });
    return ((await answer.json()) as { number: number }).number;
  }

  private own(): { secret: string | undefined } {
    return { secret: this.secret };
  }

  /** A message as it is sent, under this id. */
  sealed(post: string, message: Message, bytes?: Uint8Array): Uint8Array {
    return seal(this.key.key, packMessage(message, bytes), place(this.key.id, post, this.seat?.id ?? null));
  }

  async send(post: string, body: Uint8Array): Promise<void> {
    const query = this.seat ? `?seat=${this.seat.id}` : '';
    await this.server.ask(`${this.path}/posts/${post}${query}`, { method: 'PUT', ...this.own(), body });
  }

  async post(message: Message, bytes?: Uint8Array): Promise<string> {
    const id = newId();
    await this.send(id, this.sealed(id, message, bytes));
    return id;
  }

  /** The message of a post; null when it cannot be read with the room's key, or is none. */
  async read(post: string, seat: string | null): Promise<{ message: Message; bytes: Uint8Array } | null> {
    const sealed = await this.server.bytes(`${this.path}/posts/${post}`, { secret: this.key.secret });
    const opened = unseal(this.key.key, sealed, place(this.key.id, post, seat));
    return opened && unpackMessage(opened);
  }

  freeze(isFrozen: boolean): Promise<Response> {
    return this.server.ask(`${this.path}/frozen`, { method: isFrozen ? 'PUT' : 'DELETE', ...this.own() });
  }

  hide(post: string, isHidden: boolean): Promise<Response> {
    return this.server.ask(`${this.path}/posts/${post}/hidden`, { method: isHidden ? 'PUT' : 'DELETE', ...this.own() });
  }

  end(): Promise<Response> {
    return this.server.ask(this.path, { method: 'DELETE', ...this.own() });
  }

  closeWords(): Promise<Response> {
    return this.server.ask(`${this.path}/words`, { method: 'DELETE', ...this.own() });
  }

  /**
   * Tells `listener` all posts (or the teacher's alone) and what comes, through lost connections and those that say
   * nothing for `silence` milliseconds, until the function that it returns is called.
   */
  follow(
    listener: RoomListener,
    { of, after = 0, silence = kSilenceMs }: { of: 'all' | 'teacher'; after?: number; silence?: number },
  ): () => void {
    const stopping = new AbortController();
    const { signal } = stopping;
    let last = after;
    const take = (event: string) => {
      const told = readEvent(event);
      if (told?.name === 'post') {
        const post = told.data as ListedPost;
        last = Math.max(last, post.seq);
        listener.post(post);
      } else if (told?.name === 'state') listener.state(told.data as RoomState);
      else if (told?.name === 'ended') throw new ServerFailure('NotThere', 'This class is over.');
    };
    let tries = 0;
    const once = () =>
      whileHeard(signal, silence, async (alive, heard) => {
        const path = `${this.path}/events?after=${last}${of === 'teacher' ? '&of=teacher' : ''}`;
        const response = await this.server.ask(path, { signal: alive });
        const reader = response.body!.pipeThrough(new TextDecoderStream()).getReader();
        listener.connected(true);
        tries = 0;
        for (let text = ''; ;) {
          const { done, value } = await reader.read();
          if (done) return;
          heard();
          const events = (text + value).split('\n\n');
          text = events.pop() ?? '';
          events.forEach(take);
        }
      });
    const forEver = async () => {
      for (; !signal.aborted; tries += 1) {
        try {
          await once();
        } catch (thrown) {
          if (signal.aborted) return;
          if (thrown instanceof ServerFailure && thrown.code === 'NotThere') return listener.ended();
        }
        if (signal.aborted) return;
        listener.connected(false);
        await pause(Math.min(8000, 500 * 2 ** tries) * (0.5 + Math.random()), signal);
      }
    };
    void forEver();
    return () => stopping.abort();
  }
}

/** The server sends something every 15 s: a connection that is silent for longer is dead, as after a sleep. */
const kSilenceMs = 40_000;

/** Runs `work` with a signal that is also given when it has not called `heard` for `silence` milliseconds. */
async function whileHeard(
  stop: AbortSignal,
  silence: number,
  work: (alive: AbortSignal, heard: () => void) => Promise<void>,
): Promise<void> {
  const alive = new AbortController();
  const end = () => alive.abort();
  let last = performance.now();
  const timer = setInterval(() => {
    if (performance.now() - last > silence) end();
  }, silence / 8);
  stop.addEventListener('abort', end);
  try {
    await work(alive.signal, () => {
      last = performance.now();
    });
  } finally {
    clearInterval(timer);
    stop.removeEventListener('abort', end);
    end();
  }
}

function readEvent(text: string): { name: string; data: unknown } | null {
  const field = (name: string) => new RegExp(`^${name}: (.*)$`, 'm').exec(text)?.[1];
  const name = field('event');
  return name === undefined ? null : { name, data: JSON.parse(field('data') ?? '{}') };
}

/** Also over at once when the network comes back. */
function pause(milliseconds: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    const end = () => {
      clearTimeout(timer);
      globalThis.removeEventListener?.('online', end);
      resolve();
    };
    const timer = setTimeout(end, milliseconds);
    globalThis.addEventListener?.('online', end);
    signal.addEventListener('abort', end, { once: true });
  });
}
