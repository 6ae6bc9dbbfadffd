// Two servers on one PostgreSQL: one that stands still, as on a machine that is busy or sleeps, keeps nobody waiting.
import assert from 'node:assert/strict';
import { fork } from 'node:child_process';
import { once } from 'node:events';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { openStore } from '../../web/share/store.mjs';
import { until } from './support/server.mjs';
import { hash, id, kStoreKits } from './support/stores.mjs';

const kRoomy = { bytes: 1e9, posts: 1e6 };
const kNow = 1_800_000_000_000;
const kStops = 20;

/** In a process of its own: pupils post and sit down, some at a time, for as long as it lives. */
async function keepPosting(address, box) {
  const store = await openStore(address);
  const pupil = async () => {
    for (;;) {
      const seat = id();
      await store.putSeat({ box, seat, secret: hash() }, 1e6, kNow);
      await store.putPost({ box, post: id(), seat, bytes: Buffer.alloc(2000) }, kRoomy, kNow);
      process.send('posted');
    }
  };
  await Promise.all(Array.from({ length: 4 }, pupil));
}

if (process.argv[2] === '--posting') {
  process.on('disconnect', () => process.exit(0));
  await keepPosting(process.argv[3], process.argv[4]);
} else {
  const { make, skip } = kStoreKits.find(({ name }) => name === 'PostgreSQL');
  let kit, store, other;
  before(async () => {
    if (skip) return;
    kit = make();
    store = await kit.open();
  });
  after(async () => {
    other?.kill('SIGKILL');
    await store?.close();
    kit?.close();
  });

  test('a server that stands still holds no room: others go on posting and sitting down', { skip }, async () => {
    const box = id();
    await store.createBox({ id: box, kind: 'room', owner: hash(), expires: kNow + 1e9 }, kNow);
    other = fork(fileURLToPath(import.meta.url), ['--posting', kit.address(), box]);
    let posted = 0;
    other.on('message', () => (posted += 1));
    for (let stop = 0; stop < kStops; stop += 1) {
      const enough = posted + 5;
      await until(() => posted >= enough, 'the other server');
      other.kill('SIGSTOP');
      let isDone = false;
      const seat = id();
      const work = (async () => {
        assert.equal((await store.putSeat({ box, seat, secret: hash() }, 1e6, kNow)).result, 'made');
        const post = { box, post: id(), seat, bytes: Buffer.from('x') };
        assert.equal((await store.putPost(post, kRoomy, kNow)).result, 'stored');
        isDone = true;
      })();
      await until(() => isDone, `stop ${stop}: the server that works`);
      await work;
      other.kill('SIGCONT');
    }
    other.kill('SIGKILL');
    await once(other, 'exit');
  });
}
