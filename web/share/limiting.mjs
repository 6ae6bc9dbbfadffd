// Who asks too often. An address is kept as a hash with a salt of this run, in memory, for as long as it is counted.
import { createHash, randomBytes } from 'node:crypto';
import { isIPv6 } from 'node:net';

const kMostKeys = 20_000;

/** A network of an IPv6 address is one visitor: /64. */
function network(address) {
  if (!isIPv6(address) || address.startsWith('::ffff:')) return address;
  const [head, tail = ''] = address.split('::');
  const [before, after] = [head, tail].map((part) => part.split(':').filter(Boolean));
  const zeros = Array(Math.max(0, 8 - before.length - after.length)).fill('0');
  return [...before, ...zeros, ...after].slice(0, 4).join(':');
}

export class Addresses {
  salt = randomBytes(32);

  /** Names the address of a request without saying it. */
  of(request) {
    return createHash('sha256').update(this.salt).update(network(request.ip)).digest('base64url').slice(0, 22);
  }
}

/** Counts what went wrong in windows of time: of one key, and of all keys together. */
export class Misses {
  constructor({ max, all, timeWindow }, steady = () => performance.now()) {
    this.limits = { max, all, timeWindow };
    this.steady = steady;
    this.begin();
  }

  begin() {
    this.start = this.steady();
    this.counts = new Map();
    this.sum = 0;
  }

  /** Whether this key may try, and if not, in how many seconds. */
  wait(key) {
    const left = this.limits.timeWindow - (this.steady() - this.start);
    if (left <= 0) this.begin();
    const tooMany = this.sum >= this.limits.all || (this.counts.get(key) ?? 0) >= this.limits.max;
    return tooMany ? Math.ceil(left / 1000) : 0;
  }

  add(key) {
    this.sum += 1;
    if (this.counts.size < kMostKeys || this.counts.has(key)) this.counts.set(key, (this.counts.get(key) ?? 0) + 1);
  }
}
