// What the page says when the share server refuses (web/share/refusal.mjs), by the server's code.

const kSentences: Readonly<Record<string, string>> = {
  WrongSecret: 'This can only be done by who made it.',
  NotThere: 'There is nothing here. It has expired or was taken back.',
  TooLarge: 'This is larger than the server takes.',
  Frozen: 'The class is paused. It is sent as soon as the class goes on.',
  TooMany: 'There were too many requests from here. Wait a little.',
  RoomFull: 'This class is full.',
  ServerFull: 'The server has no room left. Try again later, or save a file.',
  Busy: 'The server is busy. Try again in a moment.',
};

export const refusalSentence = (code: string): string =>
  kSentences[code] ?? 'The server could not do this. Try again later.';
