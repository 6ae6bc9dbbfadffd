// What is posted in a room, before it is encrypted: a message as JSON, and bytes behind it.

export type Message =
  /** A pupil has come and is this animal. */
  | { type: 'seat'; animal: string; number: number }
  /** A model was handed in. The bytes are its pictures: `frames` of them side by side, a way round. */
  | { type: 'card'; name: string; model: string; frames: number; text: string; from: string | null }
  /** The bytes of a model: a GLB of ours, or a ZIP of files. */
  | { type: 'model' }
  /** The teacher shows this card to all; null: no more. */
  | { type: 'spotlight'; card: string | null }
  /** The teacher hands a card back to its maker, with a mark at a place of its picture (0…1) and some words. */
  | { type: 'back'; card: string; to: string; at: [number, number] | null; words: string }
  /** Everybody is to begin with this model. */
  | { type: 'start'; model: string; name: string };

const kLongestText = 2000,
  kLongestName = 200,
  kMostFrames = 36;

export function packMessage(message: Message, bytes: Uint8Array = new Uint8Array()): Uint8Array {
  const head = new TextEncoder().encode(JSON.stringify(message));
  const whole = new Uint8Array(4 + head.length + bytes.length);
  new DataView(whole.buffer).setUint32(0, head.length, true);
  whole.set(head, 4);
  whole.set(bytes, 4 + head.length);
  return whole;
}

const isText = (value: unknown, most: number): value is string => typeof value === 'string' && value.length <= most;
const isId = (value: unknown): value is string => isText(value, 22) && value.length === 22;
const isShare = (value: unknown) => typeof value === 'number' && value >= 0 && value <= 1;

/** What each kind must hold; anything else is nobody's message. */
const kChecks: { readonly [K in Message['type']]: (m: Record<string, unknown>) => boolean } = {
  seat: ({ animal, number }) => isText(animal, 40) && Number.isInteger(number),
  card: ({ name, model, frames, text, from }) =>
    isText(name, kLongestName) &&
    isId(model) &&
    Number.isInteger(frames) &&
    (frames as number) >= 1 &&
    (frames as number) <= kMostFrames &&
    isText(text, kLongestText) &&
    (from === null || isText(from, 40)),
  model: () => true,
  spotlight: ({ card }) => card === null || isId(card),
  back: ({ card, to, at, words }) =>
    isId(card) &&
    isId(to) &&
    isText(words, kLongestText) &&
    (at === null || (Array.isArray(at) && at.length === 2 && at.every(isShare))),
  start: ({ model, name }) => isId(model) && isText(name, kLongestName),
};

/** The message and its bytes; null when it is none, whoever sent it. */
export function unpackMessage(whole: Uint8Array): { message: Message; bytes: Uint8Array } | null {
  if (whole.length < 4) return null;
  const length = new DataView(whole.buffer, whole.byteOffset).getUint32(0, true);
  if (length > whole.length - 4) return null;
  try {
    const parsed: unknown = JSON.parse(new TextDecoder().decode(whole.subarray(4, 4 + length)));
    if (typeof parsed !== 'object' || parsed === null) return null;
    const message = parsed as Record<string, unknown>;
    const check = Object.entries(kChecks).find(([type]) => type === message['type'])?.[1];
    return check?.(message) ? { message: parsed as Message, bytes: whole.slice(4 + length) } : null;
  } catch {
    return null;
  }
}
