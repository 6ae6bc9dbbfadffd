// What the server keeps, behind one interface: in one SQLite file, or in PostgreSQL for any number of servers.
//
// Everything is a box: a stored model is a box with one post, a room is a box to which its owner (the teacher) and its
// seats (the pupils) add posts. A post is bytes that the browser encrypted; it never changes. Of secrets only hashes are
// kept. All methods are asynchronous; `now` is in milliseconds since 1970; ids are texts; hashes and bytes are Buffers.
//
//   createBox({id, kind, owner, expires}, now)          'made', 'same' (again by the same owner) or 'taken'
//   putModel({id, owner, expires, bytes}, now)          the same: a box with its one post, 'model', in one step
//   box(id, now)                                        {kind, owner, expires, frozen} or null: none, or it has expired
//   state(id)                                           {frozen, hidden: ids of posts}
//   setFrozen(id, frozen), setHidden(id, post, hidden)
//   removeBox(id)                                       with all that is in it
//   putSeat({box, seat, secret}, most, now)             {result, number}: 'made', 'same', 'taken', 'full' or 'none' (there
//                                                       is no such box); seats are numbered from 1
//   seat(box, seat)                                     hash of its secret, or null
//   putPost({box, post, seat, bytes}, limits, now)      {result, seq}: 'stored', 'same' (again, byte for byte), 'taken',
//                                                       'full', 'frozen' or 'none'. `seat` is null for the owner.
//   posts(box, {after, ofOwner, most})                  [{seq, post, seat, size, at}] in the order in which they came
//   post(box, post)                                     {seat, hidden, bytes} or null
//   putWords({locator, box, wrapped, expires}, now)     'made', instead of the words that the box had, or 'taken'
//   words(locator, now)                                 the wrapped bytes, or null
//   dropWords(box)
//   sweep(now)                                          removes what has expired; how many boxes
//   scrub()                                             what was removed leaves the files, too
//   watch(box, listener)                                listener({what}) after 'owner', 'seat', 'state', 'ended';
//                                                       returns a function that ends it
//   totals()                                            {models, rooms, posts, bytes}
//   backup(file), close()
//
// A method rejects with StoreFull when the disk or the agreed size is full, and then nothing has changed.

export class StoreFull extends Error {
  constructor() {
    super('The server has no room left. Try again later, or save a file.');
    this.name = 'StoreFull';
  }
}

/** The tables' version; a store of a later one is not opened. */
export const kStoreVersion = 1;

export class StoreTooNew extends Error {
  constructor() {
    super('This store was written by a later version of the server. Start that version, or name another file.');
    this.name = 'StoreTooNew';
  }
}

/**
 * The store at `address`: a file, or postgres://... `diskBytes` bounds the file. Libraries are loaded here, since the
 * scripts of a fresh clone run before they are installed.
 */
export async function openStore(address, options = {}) {
  if (/^postgres(ql)?:/.test(address)) {
    const { PostgresStore } = await import('./postgres_store.mjs');
    return PostgresStore.open(address, options);
  }
  const { SqliteStore } = await import('./sqlite_store.mjs');
  return SqliteStore.open(address, options);
}
