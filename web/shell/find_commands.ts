// Finding commands by words.
import type { Command } from './api.ts';

/** One line of the list: a command, or one of the choices of one. */
export interface Found {
  command: Command;
  label: string;
  args?: Record<string, unknown>;
  /** It leads to its choices. */
  leads?: boolean;
  /** The words of the choice. */
  choice?: string;
}

const wordsOf = (text: string) =>
  text
    .toLowerCase()
    .split(/[^\p{L}\p{N}]+/u)
    .filter(Boolean);

/** How well a word that was typed fits a text: it is its first word 5, one of its words 4, begins it 3, begins one of its words 2, is within it 1, is not there 0. */
function fit(word: string, text: string): number {
  const lower = text.toLowerCase();
  const words = wordsOf(lower);
  if (words[0] === word) return 5;
  if (words.includes(word)) return 4;
  if (lower.startsWith(word)) return 3;
  if (words.some((one) => one.startsWith(word))) return 2;
  return lower.includes(word) ? 1 : 0;
}

/**
 * A find in the label counts most, then one in the hint, then one in the id; a word of the hint more than letters within one
 * of the label. 0: some word is nowhere.
 */
function worth(words: string[], { label, command }: Found): number {
  let sum = 0;
  for (const word of words) {
    const best = Math.max(36 * fit(word, label), 19 * fit(word, command.hint ?? ''), fit(word, command.id));
    if (best === 0) return 0;
    sum += best;
  }
  return sum;
}

/** The choices of a command, one line each. */
export function choicesOf(command: Command): Found[] {
  const key = command.argument?.key ?? 'value';
  return (command.argument?.choices ?? []).map(({ value, label }) => ({
    command,
    label: `${command.label}: ${label}`,
    args: { [key]: value },
    choice: label,
  }));
}

/**
 * The commands that have every word of the query in their label, hint or id, the best first; of the same worth those
 * that can be run now, then those of the menus, then the order of the table. Choices of what can be run are found by their
 * own words; the words of the command find one line that leads to all of them. What only programs can give is left out.
 */
export function findCommands(commands: readonly Command[], query: string): Found[] {
  const words = wordsOf(query);
  const isMeant = ({ choice = '' }: Found) => words.some((word) => fit(word, choice) > 0);
  const all = commands
    .filter(({ argument }) => argument?.kind !== 'api')
    .flatMap((command): Found[] => {
      if (!command.argument?.choices || !command.enabled) return [{ command, label: command.label }];
      return [{ command, label: command.label, leads: true }, ...choicesOf(command).filter(isMeant)];
    });
  const rated = all.map((found, place) => ({ found, place, worth: worth(words, found) }));
  const now = ({ found }: (typeof rated)[number]) => Number(found.command.enabled);
  const menu = ({ found }: (typeof rated)[number]) => Number(Boolean(found.command.menu));
  return rated
    .filter((one) => words.length === 0 || one.worth > 0)
    .sort((a, b) => b.worth - a.worth || now(b) - now(a) || menu(b) - menu(a) || a.place - b.place)
    .map(({ found }) => found);
}
