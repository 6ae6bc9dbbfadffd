// What the share server takes, in one place. Pages of assets/docs state some of these numbers: hosting, data-protection,
// and the guide.

const kKilobyte = 1024,
  kMegabyte = 1024 * kKilobyte,
  kMinute = 60_000,
  kDay = 24 * 60 * kMinute;

export const kLimits = {
  /** Bytes of one stored model, and of one post in a room, both as the browser encrypted them. */
  modelBytes: 8 * kMegabyte,
  postBytes: 8 * kMegabyte,
  /** What a room may hold. */
  roomBytes: 512 * kMegabyte,
  roomPosts: 20_000,
  roomSeats: 400,
  /** Bodies that are being received at one time, in bytes: what comes beyond is asked to come again. */
  receivingBytes: 64 * kMegabyte,
  /** Streams of events: in one room, and in all. */
  roomStreams: 500,
  streams: 4000,
  /** Bytes that a slow reader of events may leave unread before it is cut off; it comes back where it was. */
  unreadBytes: kMegabyte,
  /** For how long things are kept. */
  modelDays: [1, 7, 30, 365],
  roomDays: 14,
  wordsMinutes: 90,
  /** Requests of one address: a school has one address for all. */
  requests: { max: 6000, timeWindow: kMinute },
  models: { max: 120, timeWindow: 10 * kMinute },
  rooms: { max: 60, timeWindow: 60 * kMinute },
  /** Join words that lead nowhere: of one address, and of all. */
  wrongWords: { max: 60, all: 600, timeWindow: 10 * kMinute },
  /** How often what has expired is removed. */
  sweepMs: 20_000,
  /** A clock that jumps is believed when it has stayed there for so long. */
  clockPatienceMs: 10 * kMinute,
};

export const minutes = (count) => count * kMinute;
export const days = (count) => count * kDay;
