// Ids, secrets and their hashes.
import { createHash, timingSafeEqual } from 'node:crypto';

/** 128 random bits in base64url: 22 characters, of which the last has two bits. */
const kId = /^[A-Za-z0-9_-]{21}[AQgw]$/;

export const isId = (text) => typeof text === 'string' && kId.test(text);

export const hashOf = (secret) => createHash('sha256').update(secret).digest();

/** The hash of the secret that a request brings ("Authorization: Bearer ..."); null where there is none. */
export function secretOf(request) {
  const [, secret] = /^Bearer ([A-Za-z0-9_-]+)$/.exec(request.headers.authorization ?? '') ?? [];
  return isId(secret) ? hashOf(secret) : null;
}

export const isSame = (a, b) => a !== null && b !== null && a.length === b.length && timingSafeEqual(a, b);
