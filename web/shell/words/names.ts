// Names and labels that the engine gives, in the visitor's language.
import type { Command } from '../api.ts';
import { t } from './words.ts';

/** A command with its words in the visitor's language: what the search looks through. */
export function inLanguage(command: Command): Command {
  const { label, hint, argument } = command;
  const choices = argument?.choices?.map((choice) => ({ ...choice, label: choiceText(choice.label) }));
  return {
    ...command,
    label: t(label),
    ...(hint ? { hint: t(hint) } : {}),
    ...(argument && choices ? { argument: { ...argument, choices } } : {}),
  };
}

/** What a choice is called: a name, words, or both parts of "Twist: One turn". */
const choiceText = (label: string): string =>
  label
    .split(': ')
    .map((words) => nameText(t(words)))
    .join(': ');

/** What the engine calls a model that nobody has named (engine/document/document.h). */
const kUnnamed = 'Model';

/** A name that the engine gave ("Part 2", "Model") in the visitor's language; any other is what a visitor typed. */
export function nameText(name: string): string {
  if (name === kUnnamed) return t(name);
  const [, word, n] = /^(Part|Solid|Group|Sketch|Picture) (\d+)$/.exec(name) ?? [];
  return word ? t(`${word} {n}`, { n: Number(n) }) : name;
}
