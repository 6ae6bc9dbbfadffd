// A room as it changes: posts are fetched as they are told of, read, and taken in their order.
import type { ListedPost, Room, RoomState } from './client.ts';
import { ClassRoom } from './class_room.ts';
import type { Message } from './messages.ts';

/** What is longer is a model, which is fetched when somebody wants it. */
const kLongestFetched = 160_000;

export interface LiveEvents {
  /** The class is another one. */
  changed(): void;
  /** The teacher did something: a new start, a spotlight, a model handed back. */
  told(post: ListedPost, message: Message): void;
  ended(): void;
  connected(isConnected: boolean): void;
}

export class LiveRoom {
  readonly room = new ClassRoom();
  private readonly stop: () => void;
  private readonly held: ListedPost[] = [];
  private queue: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly source: Room,
    of: 'all' | 'teacher',
    private readonly events: LiveEvents,
  ) {
    this.stop = source.follow(
      {
        post: (post) => this.take(post),
        state: (state: RoomState) => {
          this.room.state = state;
          // What was hidden when it came is fetched when it is shown again.
          this.held.splice(0).forEach((post) => this.take(post));
          this.events.changed();
        },
        ended: () => this.events.ended(),
        connected: (isConnected) => this.events.connected(isConnected),
      },
      { of },
    );
  }

  close(): void {
    this.stop();
  }

  private take(post: ListedPost): void {
    if (post.size > kLongestFetched) return;
    if (this.source.key.secret === undefined && this.room.state.hidden.includes(post.post)) {
      this.held.push(post);
      return;
    }
    const reading = this.readPatiently(post);
    this.queue = this.queue.then(async () => {
      const read = await reading;
      if (!read) return;
      this.room.take(post, read.message, read.bytes);
      if (post.seat === null) this.events.told(post, read.message);
      this.events.changed();
    });
  }

  /** Null: it is hidden, or nobody's message. */
  private async readPatiently(post: ListedPost): Promise<{ message: Message; bytes: Uint8Array } | null> {
    for (let tries = 0; ; tries += 1) {
      try {
        return await this.source.read(post.post, post.seat);
      } catch (thrown) {
        const { retryAfter } = thrown as { retryAfter?: number };
        if (!retryAfter || tries >= 5) return null;
        await new Promise((resolve) => setTimeout(resolve, 1000 * retryAfter));
      }
    }
  }
}
