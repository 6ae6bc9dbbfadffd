// In which class this browser is, and as whom: kept until the class is left, so that a reload or a sleep changes nothing.
import type { RoomKey, Seat } from './client.ts';

export interface Membership {
  room: RoomKey;
  /** Null: the teacher, or a screen that shows the wall. */
  seat: Seat | null;
  /** Of a pupil: the animal's id and the number of the seat. */
  animal: string;
  number: number;
  /** The room's join words as long as they are good; for the teacher. */
  words: { words: string[]; expires: number } | null;
  /** The last of the teacher's posts that this pupil was told of. */
  told: number;
  /** Whose model a model of this device was made from: by its id in "Your models". */
  origins: Record<string, string>;
}

const kKey = 'spineloft.class.1';
let here: Membership | null = null;

export function rememberClass(membership: Membership | null): void {
  here = membership;
  try {
    if (membership) localStorage.setItem(kKey, JSON.stringify(membership));
    else localStorage.removeItem(kKey);
  } catch {
    // Blocked storage: a reload leaves the class.
  }
}

export function recallClass(): Membership | null {
  try {
    here ??= JSON.parse(localStorage.getItem(kKey) ?? 'null') as Membership | null;
  } catch {
    return null;
  }
  return here;
}
