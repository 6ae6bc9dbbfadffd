// The animals under which models are put away on a device that pupils share: nobody has to give a name.
import { openDialog } from '../dialogs.ts';
import { make } from '../dom.ts';
import { icon } from '../icons.ts';
import { t } from '../words/words.ts';

export interface Animal {
  id: string;
  name: string;
}

/** Their icons have their ids. */
const kAnimals: readonly Animal[] = [
  { id: 'cat', name: 'Cat' },
  { id: 'dog', name: 'Dog' },
  { id: 'bird', name: 'Bird' },
  { id: 'fish', name: 'Fish' },
  { id: 'rabbit', name: 'Rabbit' },
  { id: 'squirrel', name: 'Squirrel' },
  { id: 'turtle', name: 'Turtle' },
  { id: 'snail', name: 'Snail' },
  { id: 'panda', name: 'Panda' },
  { id: 'shrimp', name: 'Shrimp' },
  { id: 'bug', name: 'Beetle' },
  { id: 'worm', name: 'Worm' },
];

/** The one with this id; null: there is none, and the model is nobody's. */
export function animalOf(id: string | null): Animal | null {
  return kAnimals.find((animal) => animal.id === id) ?? null;
}

/** Asks for one of the animals in a dialog, with this above them; null: none. */
export function chooseAnimal(title: string, above: Node[], look: string): Promise<Animal | null> {
  const buttons = kAnimals.map((animal) => {
    const button = make('button', { type: 'button', class: 'animal', value: animal.id }, t(animal.name));
    button.prepend(icon(animal.id));
    return button;
  });
  const grid = make('div', { class: 'animals' }, ...buttons);
  const dialog = openDialog(title, [...above, grid], look);
  return new Promise((resolve) => {
    let answer: Animal | null = null;
    grid.addEventListener('click', (event) => {
      answer = animalOf((event.target as Element).closest('button')?.value ?? null);
      if (answer) dialog.close();
    });
    dialog.addEventListener('close', () => resolve(answer));
  });
}

/** Asks under which animal so many models are put away; null: under none, everything stays. */
export function askAnimal(models: number): Promise<Animal | null> {
  const text =
    models === 1
      ? t('Choose your animal. Your model is put away under it, and the next pupil begins with an empty page.')
      : t('Choose your animal. Your {n} models are put away under it, and the next pupil begins with an empty page.', {
          n: models,
        });
  return chooseAnimal(t('Next pupil'), [make('p', {}, text)], 'dialog');
}
