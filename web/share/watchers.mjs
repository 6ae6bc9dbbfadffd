// Who follows a room: a stream of server-sent events for each, which says what came and leaves the fetching to the reader.
// A stream is told of numbers only, so that a class's worth of them costs little; a reader that is too slow is cut off and
// comes back with the number that it has.
import { kLimits } from './limits.mjs';

const kBeatMs = 15_000;
const kComeBackMs = 1500;

/** What a reader that wants `ofOwner` alone is woken by. */
const kForAll = new Set(['owner', 'state', 'ended']);

export class Watchers {
  constructor(store, clock, beatMs = kBeatMs) {
    this.store = store;
    this.clock = clock;
    this.open = new Map();
    this.count = 0;
    this.beat = setInterval(() => this.each((stream) => stream.wake()), beatMs).unref();
  }

  each(work) {
    for (const streams of this.open.values()) for (const stream of streams) work(stream);
  }

  hasPlace(box) {
    return this.count < kLimits.streams && (this.open.get(box)?.size ?? 0) < kLimits.roomStreams;
  }

  /** Follows `box` on the response `raw` from the post `after` on, until either side ends it. */
  follow(raw, box, { after, ofOwner }) {
    const stream = new Stream(this, raw, box, { after, ofOwner });
    const streams = this.open.get(box) ?? new Set();
    this.open.set(box, streams.add(stream));
    this.count += 1;
    const off = this.store.watch(box, ({ what }) => {
      if (ofOwner && !kForAll.has(what)) return;
      stream.wake();
    });
    raw.on('close', () => {
      off();
      this.count -= 1;
      streams.delete(stream);
      if (streams.size === 0) this.open.delete(box);
    });
    stream.wake();
  }

  /** Ends all streams; their readers come back, to another server or to this one. */
  close() {
    clearInterval(this.beat);
    this.each((stream) => stream.raw.end());
  }
}

class Stream {
  constructor(watchers, raw, box, { after, ofOwner }) {
    this.watchers = watchers;
    this.raw = raw;
    this.box = box;
    this.after = after;
    this.ofOwner = ofOwner;
    this.state = '';
    this.working = false;
    this.woken = false;
    raw.write(`retry: ${kComeBackMs}\n\n`);
  }

  /** Sends what there is to send; called again meanwhile, it looks once more. */
  async wake() {
    this.woken = true;
    if (this.working) return;
    this.working = true;
    try {
      while (this.woken && !this.raw.writableEnded && !this.raw.destroyed) {
        this.woken = false;
        await this.send();
      }
    } catch {
      this.raw.destroy(); // the store cannot be asked: the reader comes back
    } finally {
      this.working = false;
    }
  }

  async send() {
    const { store, clock } = this.watchers;
    if (!(await store.box(this.box, clock.now()))) {
      this.write('event: ended\ndata: {}\n\n');
      this.raw.end();
      return;
    }
    const state = JSON.stringify(await store.state(this.box));
    let text = state === this.state ? ':\n\n' : `event: state\ndata: ${state}\n\n`;
    this.state = state;
    const most = 200;
    const posts = await store.posts(this.box, { after: this.after, ofOwner: this.ofOwner, most });
    for (const post of posts) {
      text += `id: ${post.seq}\nevent: post\ndata: ${JSON.stringify(post)}\n\n`;
      this.after = post.seq;
    }
    if (posts.length === most) this.woken = true;
    this.write(text);
  }

  write(text) {
    this.raw.write(text);
    if (this.raw.writableLength > kLimits.unreadBytes) this.raw.destroy();
  }
}
