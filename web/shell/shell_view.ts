// What the DOM shows of the page: the engine sends it whenever it differs from what it sent last. Programs ask for the
// whole state instead (api.ts).
import type { Command, Part } from './api.ts';

export interface ShellView {
  documentName: string;
  pictures: number;
  parts: number;
  /** Ticked for the next solid. */
  picked: number;
  /** Solids made of parts; those of them that are hollow; parts with a live other side; parts with another slice than the round one. */
  solids: number;
  hollow: number;
  mirrored: number;
  shaped: number;
  /** The solid view was turned; the model was checked for printing as it is. */
  turned: boolean;
  checked: boolean;
  /**
   * The one in view, with its corners on the canvas; `finished`: something is drawn on it that a spine could go through;
   * `drawn`: left, top, right and bottom of the pen's lines on it, without any of the line of its first part; `buttons`:
   * where on the canvas those at the foot of its view begin.
   */
  picture: {
    width: number;
    height: number;
    sketch: boolean;
    strokes: number;
    finished: boolean;
    drawn: [left: number, top: number, right: number, bottom: number] | null;
    topLeft: { x: number; y: number };
    bottomRight: { x: number; y: number };
    buttons: number;
  } | null;
  selected: { id: number; name: string; kind: Part['kind']; ribs: number } | null;
  tool: string;
  /** A menu of the pen is open. */
  penMenu: boolean;
  undo: number;
  redo: number;
  history: { bytes: number; budget: number };
  unsaved: boolean;
  activity: { label: string; done: number } | null;
  /** A sign for each row of the command table: '1', '0', or '-' for what is no switch. */
  enabled: string;
  toggled: string;
}

/** Nothing but a sheet of paper that nobody has drawn on. */
export function isBlank({ picture, pictures, parts }: ShellView): boolean {
  return parts === 0 && pictures === 1 && picture?.sketch === true && picture.strokes === 0;
}

/** The rows of the table as they are now; their choices stay as they were. */
export function commandsNow(table: readonly Command[], { enabled, toggled }: ShellView): Command[] {
  return table.map((command, i) => ({
    ...command,
    enabled: enabled[i] === '1',
    toggled: toggled[i] === '-' ? null : toggled[i] === '1',
  }));
}
