// What the engine tells the shell.
import type { Control } from './api.ts';
import type { Place } from './text_size.ts';
import type { JournalEvent } from './keep/journal_writer.ts';
import type { KeepEvent } from './keep/keeper.ts';
import type { ShellView } from './shell_view.ts';
import type { TurntableEvent } from './turntable.ts';

/** A button of a toast that runs a command of the table. */
export interface Offer {
  label: string;
  command: string;
  args: Record<string, unknown> | null;
}

/** What the engine tells the shell; see `Host`. */
export type EngineEvent =
  | { type: 'changed'; view: ShellView }
  | { type: 'toast'; level: 'info' | 'hint' | 'warning' | 'error'; text: string; offer?: Offer }
  | { type: 'file'; name: string; mediaType: string; bytes: Uint8Array }
  | { type: 'pickPicture' }
  | { type: 'ask'; id: string; title: string; text: string; value?: string; at: Place | null }
  | { type: 'cursor'; css: string }
  /** What the panels on the canvas show, when they are at rest. */
  | { type: 'controls'; controls: Control[] }
  | { type: 'shelf'; slices: unknown[] }
  | { type: 'status'; text: string }
  /** The page is to speak this language. */
  | { type: 'language'; id: string }
  /** A dialog of the shell. */
  | { type: 'show'; dialog: 'help' | 'find-command' }
  | { type: 'stopSolving' }
  | { type: 'stopCuttingOut' }
  /** The part of a solid that is chosen, and so the likely one to be edited next. */
  | { type: 'expectEdit'; part: number | null }
  | TurntableEvent
  | JournalEvent
  | KeepEvent;

/** The same as JSON, where bytes are a place in the engine's memory. */
export type RawEvent =
  | Exclude<EngineEvent, { type: 'file' }>
  | { type: 'file'; name: string; mediaType: string; ptr: number; length: number };
