// Finding commands by words.
import type { Command } from './api.ts';

/** One line of the list: a command, or one of the choices of one. */
export interface Found {
  command: Command;
  label: string;
  args?: Record<string, unknown>;
  /** It has choices, which its words find. */
  leads?: boolean;
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

/** A find in the label counts most, then one in the hint, then one in the id. 0: some word is nowhere. */
function worth(words: string[], { label, command }: Found): number {
  let sum = 0;
  for (const word of words) {
    const best = Math.max(36 * fit(word, label), 6 * fit(word, command.hint ?? ''), fit(word, command.id));
    if (best === 0) return 0;
    sum += best;
  }
  return sum;
}

/**
 * The commands that have every word of the query in their label, hint or id, the best first; of the same worth those
 * that can be run now, then the order of the table. Choices of what can be run count once something is typed. What only programs can give
 * is left out.
 */
export function findCommands(commands: readonly Command[], query: string): Found[] {
  const words = wordsOf(query);
  const all = commands
    .filter(({ argument }) => argument?.kind !== 'api')
    .flatMap((command): Found[] => {
      const choices = command.argument?.choices;
      if (!choices || !command.enabled) return [{ command, label: command.label }];
      if (words.length === 0) return [{ command, label: command.label, leads: true }];
      const key = command.argument?.key ?? 'value';
      return choices.map(({ value, label }) => ({
        command,
        label: `${command.label}: ${label}`,
        args: { [key]: value },
      }));
    });
  const rated = all.map((found, place) => ({ found, place, worth: worth(words, found) }));
  const now = ({ found }: (typeof rated)[number]) => Number(found.command.enabled);
  return rated
    .filter((one) => words.length === 0 || one.worth > 0)
    .sort((a, b) => b.worth - a.worth || now(b) - now(a) || a.place - b.place)
    .map(({ found }) => found);
}
