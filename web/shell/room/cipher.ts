// What leaves this device for a share server is encrypted here: AES-256-GCM with a key that stands behind the '#' of a
// link and is sent to no server. Written in JavaScript (@noble/ciphers): a page of a plain http address has no
// crypto.subtle, and one way for all is one way to test.
import { gcm } from '@noble/ciphers/aes.js';
import { scrypt } from '@noble/hashes/scrypt.js';
import { wordlist } from '@scure/bip39/wordlists/english.js';
import { base64url, fromBase64url } from '../base64.ts';

const kNonceBytes = 12;

const random = (count: number): Uint8Array => crypto.getRandomValues(new Uint8Array(count));

/** 128 random bits, as 22 characters: an id, or the secret of who made something. */
export const newId = (): string => base64url(random(16));

/** 256 random bits, as 43 characters: a key. */
export const newKey = (): string => base64url(random(32));

/** Bytes of an id or a key; null when the text is none. */
export function bytesOfKey(text: string): Uint8Array | null {
  if (!/^[A-Za-z0-9_-]{43}$/.test(text)) return null;
  return fromBase64url(text);
}

function keyOf(text: string): Uint8Array {
  const key = bytesOfKey(text);
  if (!key) throw new Error('this is no key');
  return key;
}

/** `bytes` encrypted, bound to `place`: elsewhere they cannot be read. A nonce of 12 bytes stands in front. */
export function seal(key: string, bytes: Uint8Array, place: string): Uint8Array {
  const nonce = random(kNonceBytes);
  const sealed = gcm(keyOf(key), nonce, new TextEncoder().encode(place)).encrypt(bytes);
  const whole = new Uint8Array(kNonceBytes + sealed.length);
  whole.set(nonce);
  whole.set(sealed, kNonceBytes);
  return whole;
}

/** What `seal` was given; null where key, place or bytes are other ones. */
export function unseal(key: string, bytes: Uint8Array, place: string): Uint8Array | null {
  if (bytes.length <= kNonceBytes) return null;
  try {
    const cipher = gcm(keyOf(key), bytes.subarray(0, kNonceBytes), new TextEncoder().encode(place));
    return cipher.decrypt(bytes.subarray(kNonceBytes));
  } catch {
    return null;
  }
}

/** How many join words a room has: of 2,048 each, 44 bits. */
export const kJoinWords = 4;

/** Words that nobody wants to see on the wall of a class. */
const kUnfit = new Set(
  (
    'abuse alcohol bullet cannon cigar corpse crime cruel death drug drunk enemy execute expire fatal gun ' +
    'idiot kill murder naked poison punch shoot slave stupid suffer tobacco ugly victim weapon whip wine'
  ).split(' '),
);

/** Four words that a new room is joined by. */
export function newWords(): string[] {
  const words: string[] = [];
  while (words.length < kJoinWords) {
    const [low = 0, high = 0] = random(2);
    const word = wordlist[(low | (high << 8)) % wordlist.length]!; // 2048 divides 65536: each is as likely
    if (!kUnfit.has(word)) words.push(word);
  }
  return words;
}

/** The join words in what somebody typed: the first four letters of each decide. Null when it is not four words of the list. */
export function readWords(typed: string): string[] | null {
  const words = typed
    .toLowerCase()
    .split(/[^a-z]+/)
    .filter(Boolean)
    .map(
      (word) => wordlist.find((one) => one === word) ?? wordlist.find((one) => one.slice(0, 4) === word.slice(0, 4)),
    );
  return words.length === kJoinWords && words.every((word) => word !== undefined) ? (words as string[]) : null;
}

/**
 * What join words stand for: the id under which the server keeps the room's key, and the key that this is encrypted with.
 * scrypt (RFC 7914) makes each guess expensive: 32 MB and about 0.2 s on a laptop.
 */
export function keyOfWords(words: readonly string[]): { locator: string; key: string } {
  const bytes = scrypt(words.join(' '), 'spineloft class 1', { N: 2 ** 15, r: 8, p: 1, dkLen: 48 });
  return { locator: base64url(bytes.subarray(0, 16)), key: base64url(bytes.subarray(16)) };
}
