// The share server over HTTP, by the page's own client and by others who mean no good: on SQLite, and two servers on one
// PostgreSQL.
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { connect, createServer } from 'node:net';
import { after, before, describe, test } from 'node:test';
import { kStoreKits } from './support/stores.mjs';
import { loadClient, rawAsk, startServer, until } from './support/server.mjs';

const { ClassRoom, Room, ShareServer, keyOfWords, newId, newWords, readWords, seal, unseal } = await loadClient();

const code = (promise) =>
  promise.then(
    () => null,
    (failure) => failure.code,
  );

/** Follows a room and notes what it is told; `posts` in the order in which they came. */
function listener() {
  const heard = { posts: [], states: [], ended: false, connected: [] };
  return {
    ...heard,
    post(post) {
      this.posts.push(post);
    },
    state(state) {
      this.states.push(state);
    },
    ended() {
      this.isOver = true;
    },
    connected(on) {
      this.isConnected = on;
    },
  };
}

async function classOf(url, pupils, days = 1) {
  const server = new ShareServer(url);
  const key = await server.openRoom(days);
  const teacher = new Room(server, key, null);
  const seats = Array.from(
    { length: pupils },
    () => new Room(server, { id: key.id, key: key.key }, { id: newId(), secret: newId() }),
  );
  const numbers = [];
  for (const seat of seats) numbers.push(await seat.sit());
  return { server, key, teacher, seats, numbers };
}

for (const { name, make, skip } of kStoreKits) {
  describe(name, { skip }, () => {
    let kit, first, second;
    before(async () => {
      kit = make();
      first = await startServer(await kit.open());
      second = kit.name === 'SQLite' ? first : await startServer(await kit.again());
    });
    after(async () => {
      await first?.close();
      if (second !== first) await second?.close();
      kit?.close();
    });

    test('a stored model opens with its key alone, wherever it is asked for, until it is taken back', async () => {
      const bytes = randomBytes(200_000);
      const made = await new ShareServer(first.url).storeModel(bytes, 30);
      const other = new ShareServer(second.url);
      assert.deepEqual(Buffer.from(await other.storedModel(made)), bytes);
      const raw = Buffer.from(await (await fetch(`${second.url}models/${made.id}`)).arrayBuffer());
      assert.ok(!raw.includes(bytes.subarray(0, 64)));
      assert.equal(
        await code(other.storedModel({ ...made, key: made.key.replace(/^./, (c) => (c === 'A' ? 'B' : 'A')) })),
        'WrongKey',
      );
      assert.equal(await code(other.takeBack({ id: made.id, secret: newId() })), 'WrongSecret');
      assert.equal((await rawAsk(first.port, `/share/v1/models/${made.id}`, { method: 'DELETE' })).status, 401);
      await other.takeBack(made);
      assert.equal(await code(other.storedModel(made)), 'NotThere');
      assert.equal(await code(other.takeBack(made)), 'NotThere');
    });

    test('sent again it is stored once; only the agreed days are taken', async () => {
      const { url, port } = first;
      const [id, secret] = [newId(), newId()];
      const put = (body, query = '?days=7', by = secret) =>
        fetch(`${url}models/${id}${query}`, {
          method: 'PUT',
          headers: { Authorization: `Bearer ${by}`, 'Content-Type': 'application/octet-stream' },
          body,
        });
      assert.equal((await put('abc', '?days=8')).status, 400);
      assert.equal((await put('abc')).status, 201);
      assert.equal((await put('abc')).status, 200);
      assert.equal((await put('abd')).status, 409);
      assert.equal((await put('abc', '?days=7', newId())).status, 409);
      assert.equal((await put('')).status, 400);
      assert.equal((await rawAsk(port, `/share/v1/models/${id}`)).body, 'abc');
    });

    test('four words lead to the room until there are others; what pupils and teacher post reaches both', async () => {
      const { server, key, teacher, seats, numbers } = await classOf(first.url, 3);
      assert.deepEqual(numbers, [1, 2, 3]);
      const { words } = await server.nameRoom(key);
      const there = new ShareServer(second.url);
      assert.deepEqual(await there.findRoom(readWords(words.join(' ').toUpperCase())), { id: key.id, key: key.key });
      const again = await server.nameRoom(key);
      assert.equal(await code(there.findRoom(words)), 'NotThere');
      assert.equal((await there.findRoom(again.words)).id, key.id);

      const heard = listener();
      const stop = new Room(there, { id: key.id, key: key.key }, null).follow(heard, { of: 'all' });
      try {
        const model = await seats[0].post({ type: 'model' }, randomBytes(1000));
        const card = { type: 'card', name: '<b>x</b>', model, frames: 1, text: '', from: null };
        const post = await seats[0].post(card, Buffer.from('pictures'));
        await teacher.post({ type: 'spotlight', card: post });
        await until(() => heard.posts.length === 3, 'three posts');
        assert.deepEqual(
          heard.posts.map(({ seat }) => seat),
          [seats[0].seat.id, seats[0].seat.id, null],
        );
        const room = new ClassRoom();
        for (const listed of heard.posts) {
          const { message, bytes } = await teacher.read(listed.post, listed.seat);
          room.take(listed, message, bytes);
        }
        assert.equal(room.shown().name, '<b>x</b>');
        assert.equal(Buffer.from(room.shown().pictures).toString(), 'pictures');
      } finally {
        stop();
      }
    });

    test('frozen: pupils wait and the teacher goes on; hidden: the teacher alone can read it; ended: nothing is there', async () => {
      const { key, teacher, seats } = await classOf(first.url, 1);
      const heard = listener();
      const guest = new Room(new ShareServer(second.url), { id: key.id, key: key.key }, null);
      const stop = guest.follow(heard, { of: 'all' });
      const post = await seats[0].post({ type: 'seat', animal: 'cat', number: 1 });
      await teacher.freeze(true);
      await until(() => heard.states.at(-1)?.frozen === true, 'the state');
      assert.equal(await code(seats[0].post({ type: 'model' })), 'Frozen');
      await teacher.post({ type: 'spotlight', card: null });
      await teacher.freeze(false);
      await seats[0].post({ type: 'model' });
      await teacher.hide(post, true);
      await until(() => heard.states.at(-1)?.hidden.includes(post), 'the hidden post');
      assert.equal(await code(guest.read(post, seats[0].seat.id)), 'NotThere');
      assert.equal((await teacher.read(post, seats[0].seat.id)).message.animal, 'cat');
      await teacher.hide(post, false);
      assert.equal((await guest.read(post, seats[0].seat.id)).message.animal, 'cat');
      for (const act of [() => seats[0].freeze(true), () => seats[0].hide(post, true), () => seats[0].end()])
        assert.equal(await code(act()), 'WrongSecret');
      await teacher.end();
      await until(() => heard.isOver, 'the end');
      assert.equal(await code(guest.read(post, seats[0].seat.id)), 'NotThere');
      assert.equal(await code(seats[0].post({ type: 'model' })), 'NotThere');
      stop();
    });

    test('nobody posts as another pupil or as the teacher, and a seat keeps its number', async () => {
      const { key, server, seats } = await classOf(first.url, 2);
      const impostor = new Room(server, { id: key.id, key: key.key }, { id: seats[0].seat.id, secret: newId() });
      assert.equal(await code(impostor.post({ type: 'model' })), 'WrongSecret');
      assert.equal(await code(impostor.sit()), 'Taken');
      const asTeacher = new Room(server, { ...key, secret: seats[0].seat.secret }, null);
      assert.equal(await code(asTeacher.post({ type: 'spotlight', card: null })), 'WrongSecret');
      assert.equal(await seats[1].sit(), 2);
      // What the server moves to another place cannot be read there.
      const post = await seats[0].post({ type: 'model' });
      assert.equal(await seats[1].read(post, seats[1].seat.id), null);
    });

    test('who lost the connection comes back to what was posted meanwhile, once', async () => {
      const { key, seats } = await classOf(first.url, 1);
      const heard = listener();
      const stop = new Room(new ShareServer(second.url), { id: key.id, key: key.key }, null).follow(heard, {
        of: 'all',
      });
      try {
        await seats[0].post({ type: 'model' });
        await until(() => heard.posts.length === 1, 'the first post');
        second.server.closeAllConnections();
        await seats[0].post({ type: 'model' }).catch(() => seats[0].post({ type: 'model' }));
        await seats[0].post({ type: 'model' });
        await until(() => heard.posts.length >= 3, 'all posts');
        const seqs = heard.posts.map(({ seq }) => seq);
        assert.deepEqual(
          seqs,
          [...new Set(seqs)].sort((a, b) => a - b),
        );
      } finally {
        stop();
      }
    });

    test('a room stays for 14 days at most, and its join words for 90 minutes', async () => {
      const { url } = first;
      const secret = newId();
      const put = async (path, body) => {
        const headers = { Authorization: `Bearer ${secret}` };
        if (body) headers['Content-Type'] = 'application/octet-stream';
        const response = await fetch(`${url}${path}`, { method: 'PUT', headers, body });
        return { status: response.status, ...(await response.json()) };
      };
      for (const days of ['15', '0', '-1', '1.5', 'x', '1e9', 'Infinity'])
        assert.equal((await put(`rooms/${newId()}?days=${days}`)).status, 400, days);
      const isIn = (expires, milliseconds) => Math.abs(expires - Date.now() - milliseconds) < 60_000;
      const room = newId();
      for (const [id, query] of [
        [room, '?days=14'],
        [newId(), ''],
      ]) {
        const made = await put(`rooms/${id}${query}`);
        assert.equal(made.status, 201);
        assert.ok(isIn(made.expires, 14 * 24 * 3_600_000), `${made.expires}`);
      }
      const named = await put(`rooms/${room}/words/${newId()}`, randomBytes(80));
      assert.equal(named.status, 201);
      assert.ok(isIn(named.expires, 90 * 60_000), `${named.expires}`);
    });

    test('what expires is swept, by the clock of the server', async () => {
      const made = await new ShareServer(first.url).storeModel(randomBytes(10), 1);
      assert.equal(await first.store.sweep(Date.now() + 23 * 3_600_000), 0);
      assert.ok((await first.store.sweep(Date.now() + 25 * 3_600_000)) >= 1);
      assert.equal(await code(new ShareServer(first.url).storedModel(made)), 'NotThere');
    });
  });
}

/** Passes connections on to a server; `mute()`: of the streams of events that are open, nothing is passed on any more. */
async function proxyTo(port) {
  const streams = [];
  const proxy = createServer((client) => {
    const server = connect(port, '127.0.0.1');
    const one = { isMute: false };
    for (const [from, to] of [
      [client, server],
      [server, client],
    ]) {
      from.on('error', () => undefined);
      from.on('close', () => to.destroy());
    }
    client.on('data', (bytes) => {
      if (bytes.includes('/events')) streams.push(one);
      server.write(bytes);
    });
    server.on('data', (bytes) => one.isMute || client.write(bytes));
  });
  await new Promise((resolve) => proxy.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${proxy.address().port}/share/v1/`,
    streams,
    mute: () => streams.forEach((one) => (one.isMute = true)),
    close: () => proxy.close(),
  };
}

test('a stream of events that has gone silent, as after a sleep, is opened again, and the same animal goes on', async () => {
  const kit = kStoreKits[0].make();
  const server = await startServer(await kit.open(), { limits: { beatMs: 50 } });
  const proxy = await proxyTo(server.port);
  const heard = listener();
  let stop;
  try {
    const { key, teacher } = await classOf(server.url, 2);
    const seat = { id: newId(), secret: newId() };
    const pupil = new Room(new ShareServer(proxy.url), { id: key.id, key: key.key }, seat);
    const number = await pupil.sit();
    assert.equal(number, 3);
    await pupil.post({ type: 'seat', animal: 'snail', number });
    const silence = 1500;
    stop = pupil.follow(heard, { of: 'all', silence });
    await until(() => heard.posts.length === 1, 'the own post');
    // Nothing happens, and the beats keep the stream open.
    await new Promise((done) => setTimeout(done, 2.5 * silence));
    assert.equal(proxy.streams.length, 1);
    proxy.mute();
    const missed = await teacher.post({ type: 'spotlight', card: null });
    await until(() => heard.posts.length === 2, 'what was posted meanwhile');
    assert.equal(heard.posts[1].post, missed);
    assert.equal(proxy.streams.length, 2);
    assert.equal(await pupil.sit(), number);
    const next = await pupil.post({ type: 'model' });
    await until(() => heard.posts.length === 3, 'what the pupil posts then');
    assert.deepEqual([heard.posts[2].post, heard.posts[2].seat], [next, seat.id]);
    const room = new ClassRoom();
    for (const listed of heard.posts) {
      const { message, bytes } = await teacher.read(listed.post, listed.seat);
      room.take(listed, message, bytes);
    }
    assert.deepEqual(
      [...room.pupils.values()].map(({ animal }) => animal),
      ['snail'],
    );
  } finally {
    stop?.();
    await server.close();
    proxy.close();
    kit.close();
  }
});

describe('whoever asks', () => {
  let kit, server;
  before(async () => {
    kit = kStoreKits[0].make();
    server = await startServer(await kit.open(), {
      limits: { requests: { max: 100_000, timeWindow: 60_000 } },
      times: { headersTimeout: 1000, connectionsCheckingInterval: 100 },
    });
  });
  after(async () => {
    await server.close();
    kit.close();
  });

  test('paths and ids that are none are refused in a sentence, and every answer forbids a browser to run it', async () => {
    const { port } = server;
    const id = newId();
    for (const path of [
      '/share/v1/models/../../etc/passwd',
      '/share/v1/models/%2e%2e%2f%2e%2e%2fetc%2fpasswd',
      `/share/v1/models/${id}%00`,
      `/share/v1/models/${id.slice(1)}`,
      `/share/v1/models/${id}x`,
      '/share/v1/models/%zz',
      "/share/v1/models/';DROP%20TABLE%20boxes;--",
      '/share/v1/models/<script>alert(1)</script>',
      `/share/v1/rooms/${id}/events?after=-1`,
      `/share/v1/rooms/${id}/events?after=1e99`,
      '/share/v1/rooms/__proto__',
      '/share/v1/words/constructor',
      '/share/nothing',
      '/v1/models/',
      '//',
    ]) {
      const { status, headers, body } = await rawAsk(port, path);
      assert.ok(status === 400 || status === 404, `${path}: ${status}`);
      assert.match(headers['content-security-policy'] ?? '', /default-src 'none'.*sandbox/, path);
      assert.equal(headers['x-content-type-options'], 'nosniff');
      assert.equal(headers['set-cookie'], undefined);
      assert.match(headers['content-type'], /^application\/json/);
      assert.match(JSON.parse(body).message, /^[A-Z].*\.$/);
      assert.ok(!body.includes('script'), path);
    }
  });

  test('what is too long, of unknown length or of another kind is refused before it is kept', async () => {
    const { port } = server;
    const path = `/share/v1/models/${newId()}`;
    const headers = { Authorization: `Bearer ${newId()}`, 'Content-Type': 'application/octet-stream' };
    const large = await rawAsk(port, path, {
      method: 'PUT',
      headers: { ...headers, 'Content-Length': 9 * 2 ** 20 },
    }).catch((error) => error);
    assert.ok(large.status === 413 || large.code === 'ECONNRESET', String(large.status ?? large));
    const chunked = await rawAsk(port, path, {
      method: 'PUT',
      headers: { ...headers, 'Transfer-Encoding': 'chunked' },
      body: 'abc',
    });
    assert.equal(chunked.status, 411);
    const text = await rawAsk(port, path, {
      method: 'PUT',
      headers: { ...headers, 'Content-Type': 'application/json', 'Content-Length': 2 },
      body: '{}',
    });
    assert.equal(text.status, 400);
    assert.equal((await rawAsk(port, path)).status, 404);
    assert.deepEqual(server.said, []);
  });

  test('join words that lead nowhere are counted: after 60 of one address it has to wait', async () => {
    const { key, server: room } = await classOf(server.url, 0);
    const { words } = await room.nameRoom(key);
    const { locator } = keyOfWords(words);
    for (let i = 0; i < 60; i += 1) {
      assert.equal((await rawAsk(server.port, `/share/v1/words/${locator}`)).status, 200);
      assert.equal((await rawAsk(server.port, `/share/v1/words/${newId()}`)).status, 404);
    }
    const { status, headers } = await rawAsk(server.port, `/share/v1/words/${locator}`);
    assert.equal(status, 429);
    assert.ok(Number(headers['retry-after']) > 0);
  });

  test('health and numbers are told; numbers not to others', async () => {
    assert.deepEqual(JSON.parse((await rawAsk(server.port, '/share/healthz')).body), { ok: true });
    const { body } = await rawAsk(server.port, '/share/metrics');
    assert.match(body, /spineloft_requests_total\{method="GET",route="\/v1\/words\/:locator",status="404"\} 60/);
    assert.ok(!/127\.0\.0\.1/.test(body));
    const forwarded = await rawAsk(server.port, '/share/metrics', { headers: { 'X-Forwarded-For': '127.0.0.1' } });
    assert.equal(forwarded.status, 404);
  });

  test('a client that sends its request letter by letter does not keep others waiting, and is cut off', async () => {
    const slow = Array.from({ length: 50 }, () => connect(server.port, '127.0.0.1'));
    let closed = 0;
    for (const socket of slow) {
      socket.on('error', () => undefined);
      socket.on('close', () => (closed += 1)).resume();
      socket.write('GET /share/healthz HTTP/1.1\r\nHost: x\r\n');
    }
    assert.equal((await rawAsk(server.port, '/share/healthz')).status, 200);
    await until(() => closed === 50, 'the slow ones are cut off', 40_000);
  });

  test('a body that is sent letter by letter is ended in its time, and gives back its share of what is received', async () => {
    const slow = await startServer(await kit.open(), {
      times: { requestTimeout: 2000, headersTimeout: 1000, connectionsCheckingInterval: 100 },
    });
    const head = (length) =>
      `PUT /share/v1/models/${newId()} HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer ${newId()}\r\n` +
      `Content-Type: application/octet-stream\r\nContent-Length: ${length}\r\n\r\n`;
    const put = () => code(new ShareServer(slow.url).storeModel(randomBytes(10), 1));
    // Together they announce as much as may be received at one time.
    const count = 8;
    let closed = 0;
    const sockets = Array.from({ length: count }, () => connect(slow.port, '127.0.0.1'));
    const started = performance.now();
    for (const socket of sockets) {
      socket.on('error', () => undefined);
      socket.on('close', () => (closed += 1)).resume();
      socket.write(head((64 / count) * 2 ** 20));
    }
    const typing = setInterval(() => sockets.forEach((socket) => socket.writable && socket.write('x')), 100);
    try {
      await until(async () => (await put()) === 'Busy', 'the bodies fill what may be received');
      assert.equal((await rawAsk(slow.port, '/share/healthz')).status, 200);
      await until(() => closed === count, 'the slow bodies are ended', 40_000);
      assert.ok(performance.now() - started >= 2000, 'not before their time');
      assert.equal(await put(), null);
      assert.deepEqual(slow.said, []);
    } finally {
      clearInterval(typing);
      sockets.forEach((socket) => socket.destroy());
      await slow.close();
    }
  });

  test('a reader of events that takes nothing is cut off, and the memory that it costs is bounded', async () => {
    const { key, seats } = await classOf(server.url, 1);
    const socket = connect(server.port, '127.0.0.1');
    socket.pause();
    socket.on('error', () => undefined);
    socket.write(`GET /share/v1/rooms/${key.id}/events HTTP/1.1\r\nHost: x\r\n\r\n`);
    await until(() => server.share.streams() === 1, 'the stream');
    const { store } = server;
    store.db.pragma('synchronous = OFF'); // it is about sending
    const before = process.memoryUsage.rss();
    // Events of 5 MB: more than sockets buffer and a stream may hold.
    const seat = seats[0].seat.id;
    const limits = { bytes: 1e9, posts: 1e6 };
    for (let i = 0; i < 30_000; i += 1) {
      await store.putPost({ box: key.id, post: newId(), seat, bytes: Buffer.from('x') }, limits, Date.now());
    }
    await until(() => server.share.streams() === 0, 'the slow reader is cut off');
    assert.ok(process.memoryUsage.rss() - before < 200 * 2 ** 20);
    socket.destroy();
  });
});

test('10,000 posts from one address: that address has to wait, another is answered, and what was acknowledged is there', async () => {
  const kit = kStoreKits[0].make();
  const kMost = 500;
  const server = await startServer(await kit.open(), {
    trustProxy: true,
    limits: { requests: { max: kMost, timeWindow: 3_600_000 } },
  });
  try {
    const { key, seats } = await classOf(server.url, 1);
    const path = `/share/v1/rooms/${key.id}/posts/`;
    const headers = { Authorization: `Bearer ${seats[0].seat.secret}`, 'Content-Type': 'application/octet-stream' };
    const statuses = { 201: 0, 429: 0 };
    const kept = [];
    const lane = async () => {
      while (statuses[201] + statuses[429] < 10_000) {
        const post = newId();
        const { status } = await rawAsk(server.port, `${path}${post}?seat=${seats[0].seat.id}`, {
          method: 'PUT',
          headers: { ...headers, 'X-Forwarded-For': '203.0.113.7', 'Content-Length': 3 },
          body: 'abc',
        });
        statuses[status] = (statuses[status] ?? 0) + 1;
        if (status === 201) kept.push(post);
      }
    };
    await Promise.all(Array.from({ length: 20 }, lane));
    assert.deepEqual(Object.keys(statuses), ['201', '429']);
    assert.equal(statuses[201], kMost);
    assert.equal(
      (await rawAsk(server.port, '/share/healthz', { headers: { 'X-Forwarded-For': '203.0.113.8' } })).status,
      200,
    );
    const listed = new Set();
    for (
      let at = 0, page;
      (page = await server.store.posts(key.id, { after: at, most: 1000 })).length;
      at = page.at(-1).seq
    )
      for (const { post } of page) listed.add(post);
    assert.equal(listed.size, kept.length);
    for (const post of kept) assert.ok(listed.has(post));
    assert.deepEqual(server.said, []);
  } finally {
    await server.close();
    kit.close();
  }
});

test('sealed bytes open with their key at their place alone, and no bit of them can be changed', () => {
  const key = Buffer.from(randomBytes(32)).toString('base64url');
  for (const length of [0, 1, 1000]) {
    const bytes = randomBytes(length);
    const sealed = seal(key, bytes, 'here');
    assert.deepEqual(Buffer.from(unseal(key, sealed, 'here')), bytes);
    assert.equal(unseal(key, sealed, 'there'), null);
    for (let i = 0; i < sealed.length; i += 1 + Math.floor(length / 50)) {
      const changed = sealed.slice();
      changed[i] ^= 1 << (i % 8);
      assert.equal(unseal(key, changed, 'here'), null);
      assert.equal(unseal(key, sealed.slice(0, i), 'here'), null);
    }
  }
});

test('join words are four of 2,048 with different first four letters, and are read as they are typed', () => {
  for (let i = 0; i < 200; i += 1) {
    const words = newWords();
    assert.equal(words.length, 4);
    assert.deepEqual(readWords(words.join(' ')), words);
    assert.deepEqual(readWords(`  ${words.map((word) => word.slice(0, 4).toUpperCase()).join(', ')} `), words);
  }
  for (const typed of [
    '',
    'one two three',
    'zzzz zzzz zzzz zzzz',
    '<script>',
    'abandon abandon abandon abandon abandon',
  ])
    assert.equal(readWords(typed), null);
});
