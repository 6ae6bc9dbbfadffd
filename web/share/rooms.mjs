// Rooms of a class: /v1/rooms/ID. The teacher is who has the room's secret; a pupil has a seat with a secret of its own.
// What they post is encrypted; of the room the server knows who posted, when and how much, and what is hidden.
import { days, kLimits, minutes } from './limits.mjs';
import { Refusal } from './refusal.mjs';
import { isSame, secretOf } from './secrets.mjs';

const kRoomLimits = { bytes: kLimits.roomBytes, posts: kLimits.roomPosts };
const kRefused = { none: 'NotThere', taken: 'Taken', full: 'RoomFull', frozen: 'Frozen' };
/** Bytes of the room's id and key as the join words encrypt them. */
const kWrapped = { least: 32, most: 512 };

export function roomRoutes(app, { store, clock, addresses, misses, watchers, idOf, needSecret, bytesOf, sendBytes }) {
  async function roomOf(request) {
    const id = idOf(request.params.room);
    const box = await store.box(id, clock.now());
    if (box?.kind !== 'room') throw new Refusal('NotThere');
    return { id, ...box };
  }

  async function asTeacher(request) {
    const secret = needSecret(request);
    const room = await roomOf(request);
    if (!isSame(room.owner, secret)) throw new Refusal('WrongSecret');
    return room;
  }

  app.put('/v1/rooms/:room', { config: { rateLimit: kLimits.rooms } }, async (request, reply) => {
    const id = idOf(request.params.room);
    const owner = needSecret(request);
    const kept = Number(request.query.days ?? kLimits.roomDays);
    if (!Number.isInteger(kept) || kept < 1 || kept > kLimits.roomDays) throw new Refusal('BadRequest');
    const now = clock.now();
    const result = await store.createBox({ id, kind: 'room', owner, expires: now + days(kept) }, now);
    if (result === 'taken') throw new Refusal('Taken');
    return reply.code(result === 'made' ? 201 : 200).send({ expires: now + days(kept) });
  });

  app.get('/v1/rooms/:room', async (request) => {
    const { id, expires } = await roomOf(request);
    return { expires, ...(await store.state(id)) };
  });

  app.delete('/v1/rooms/:room', async (request, reply) => {
    const { id } = await asTeacher(request);
    await store.removeBox(id);
    return reply.code(204).send();
  });

  app.put('/v1/rooms/:room/frozen', async (request, reply) => {
    const { id } = await asTeacher(request);
    await store.setFrozen(id, true);
    return reply.code(204).send();
  });

  app.delete('/v1/rooms/:room/frozen', async (request, reply) => {
    const { id } = await asTeacher(request);
    await store.setFrozen(id, false);
    return reply.code(204).send();
  });

  for (const [method, hidden] of [
    ['put', true],
    ['delete', false],
  ]) {
    app[method]('/v1/rooms/:room/posts/:post/hidden', async (request, reply) => {
      const { id } = await asTeacher(request);
      await store.setHidden(id, idOf(request.params.post), hidden);
      return reply.code(204).send();
    });
  }

  app.put('/v1/rooms/:room/seats/:seat', async (request, reply) => {
    const secret = needSecret(request);
    const { id } = await roomOf(request);
    const seat = idOf(request.params.seat);
    const { result, number } = await store.putSeat({ box: id, seat, secret }, kLimits.roomSeats, clock.now());
    if (kRefused[result]) throw new Refusal(kRefused[result]);
    return reply.code(result === 'made' ? 201 : 200).send({ number });
  });

  // Of the teacher without `seat`, else of the pupil there. Again with the same bytes it changes nothing.
  app.put('/v1/rooms/:room/posts/:post', { bodyLimit: kLimits.postBytes }, async (request, reply) => {
    const secret = needSecret(request);
    const room = await roomOf(request);
    const post = idOf(request.params.post);
    const seat = request.query.seat === undefined ? null : idOf(request.query.seat);
    const known = seat === null ? room.owner : await store.seat(room.id, seat);
    if (!isSame(known, secret)) throw new Refusal('WrongSecret');
    const bytes = bytesOf(request);
    const { result, seq } = await store.putPost({ box: room.id, post, seat, bytes }, kRoomLimits, clock.now());
    if (kRefused[result]) throw new Refusal(kRefused[result], result === 'frozen' ? 5 : undefined);
    return reply.code(result === 'stored' ? 201 : 200).send({ seq });
  });

  app.get('/v1/rooms/:room/posts/:post', async (request, reply) => {
    const room = await roomOf(request);
    const post = await store.post(room.id, idOf(request.params.post));
    if (!post) throw new Refusal('NotThere');
    // What is hidden is for the teacher.
    if (post.hidden && !isSame(room.owner, secretOf(request))) throw new Refusal('NotThere');
    return sendBytes(reply, post.bytes);
  });

  app.get('/v1/rooms/:room/events', async (request, reply) => {
    const { id } = await roomOf(request);
    const after = Number(request.headers['last-event-id'] ?? request.query.after ?? 0);
    if (!Number.isInteger(after) || after < 0 || after > 2 ** 31 - 1) throw new Refusal('BadRequest');
    if (!watchers.hasPlace(id)) throw new Refusal('Busy', 10);
    reply.hijack();
    const { raw } = reply;
    raw.writeHead(200, {
      ...reply.getHeaders(),
      'Content-Type': 'text/event-stream; charset=utf-8',
      'X-Accel-Buffering': 'no', // a proxy is to pass each event on at once
      Connection: 'keep-alive',
    });
    watchers.follow(raw, id, { after, ofOwner: request.query.of === 'teacher' });
  });

  app.put('/v1/rooms/:room/words/:locator', { bodyLimit: kWrapped.most }, async (request, reply) => {
    const { id, expires } = await asTeacher(request);
    const wrapped = bytesOf(request);
    if (wrapped.length < kWrapped.least) throw new Refusal('BadRequest');
    const now = clock.now();
    const until = Math.min(expires, now + minutes(kLimits.wordsMinutes));
    const words = { locator: idOf(request.params.locator), box: id, wrapped, expires: until };
    if ((await store.putWords(words, now)) === 'taken') throw new Refusal('Taken');
    return reply.code(201).send({ expires: until });
  });

  app.delete('/v1/rooms/:room/words', async (request, reply) => {
    const { id } = await asTeacher(request);
    await store.dropWords(id);
    return reply.code(204).send();
  });

  // Where join words lead. Only what leads nowhere is counted: a class comes from one address.
  app.get('/v1/words/:locator', async (request, reply) => {
    const address = addresses.of(request);
    const wait = misses.wait(address);
    if (wait > 0) throw new Refusal('TooMany', wait);
    const wrapped = await store.words(idOf(request.params.locator), clock.now());
    if (!wrapped) {
      misses.add(address);
      throw new Refusal('NotThere');
    }
    return sendBytes(reply, wrapped);
  });
}
