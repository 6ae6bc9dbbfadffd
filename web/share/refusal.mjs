// Why a request is refused: a status, a code for the page and a sentence for a person.

const kRefusals = {
  BadRequest: [400, 'This request is not one of this server.'],
  NeedsSecret: [401, 'This can only be done by who has its secret.'],
  WrongSecret: [403, 'This can only be done by who made it.'],
  NotThere: [404, 'There is nothing here. It has expired or was taken back.'],
  Taken: [409, 'There is something else under this id.'],
  LengthMissing: [411, 'The length of what is sent must be said first.'],
  TooLarge: [413, 'This is larger than the server takes.'],
  Frozen: [423, 'The class is paused. It is sent as soon as the class goes on.'],
  TooMany: [429, 'There were too many requests from here. Wait a little.'],
  RoomFull: [507, 'This class is full.'],
  ServerFull: [507, 'The server has no room left. Try again later, or save a file.'],
  Busy: [503, 'The server is busy. Try again in a moment.'],
  Failed: [500, 'The server could not do this. Try again later.'],
};

export class Refusal extends Error {
  constructor(code, after) {
    const [status, sentence] = kRefusals[code];
    super(sentence);
    this.code = code;
    this.statusCode = status;
    this.after = after;
  }
}
