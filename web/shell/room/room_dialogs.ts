// The dialogs of a class: opening one, joining one, choosing an animal, and one model of the wall.
import { openDialog } from '../dialogs.ts';
import { asIs, make } from '../dom.ts';
import { chooseAnimal } from '../keep/animals.ts';
import type { Animal } from '../keep/animals.ts';
import { t } from '../words/words.ts';
import type { Card } from './class_room.ts';
import { iconButton } from './faces.ts';

const kDays = [1, 7, 14];

/** What https would make better; nothing where the page has it. */
function plainNote(): Node[] {
  if (isSecureContext) return [];
  const text =
    'This address is plain http. Everything works; with https the page would be faster and would also open without a network.';
  return [make('p', { class: 'class-note' }, text)];
}

/** Asks a teacher whether to open a class and for how many days its wall stays; null: not now. */
export function askOpenClass(): Promise<number | null> {
  const choice = make('select', { id: 'class-days' });
  for (const days of kDays)
    choice.append(make('option', { value: String(days) }, days === 1 ? t('1 day') : t('{n} days', { n: days })));
  const open = make('button', { type: 'submit', class: 'button button-primary' }, 'Open the class');
  const form = make(
    'form',
    { method: 'dialog' },
    make('p', {}, 'Pupils join with four words or a QR code and pick an animal: no names, no accounts.'),
    make('p', {}, 'What they hand in is encrypted in their browsers. The server keeps it and cannot look at it.'),
    make('label', { for: 'class-days' }, 'Keep the wall for'),
    choice,
    make('div', { class: 'dialog-buttons' }, open),
  );
  form.append(...plainNote());
  const dialog = openDialog('Open a class', [form], 'dialog class-dialog');
  return new Promise((resolve) => {
    let answer: number | null = null;
    form.addEventListener('submit', () => {
      answer = Number(choice.value);
    });
    dialog.addEventListener('close', () => resolve(answer));
  });
}

/** Asks for the four words until `find` has found the class; null: not now. */
export function askWords<T>(find: (typed: string) => Promise<T>): Promise<T | null> {
  const input = make('input', {
    type: 'text',
    id: 'class-words',
    autocomplete: 'off',
    autocapitalize: 'none',
    spellcheck: 'false',
    maxlength: '200',
  });
  const problem = make('p', { class: 'class-problem', role: 'alert' });
  const join = make('button', { type: 'submit', class: 'button button-primary' }, 'Join');
  const form = make(
    'form',
    {},
    make('label', { for: 'class-words' }, 'The four words on the wall'),
    input,
    problem,
    make('div', { class: 'dialog-buttons' }, join),
  );
  const dialog = openDialog('Join a class', [form], 'dialog class-dialog');
  input.focus();
  return new Promise((resolve) => {
    let answer: T | null = null;
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      join.disabled = true;
      problem.replaceChildren(t('Looking for the class …'));
      // The sentence is shown before the key is derived, which takes a moment.
      setTimeout(() => {
        find(input.value)
          .then((found) => {
            answer = found;
            dialog.close();
          })
          .catch((thrown: Error) => {
            problem.replaceChildren(t(thrown.message));
            join.disabled = false;
            input.focus();
          });
      }, 30);
    });
    dialog.addEventListener('close', () => resolve(answer));
  });
}

/** Asks which animal a pupil wants to be; null: none. */
export function askSeat(): Promise<Animal | null> {
  return chooseAnimal(t('Which animal are you?'), plainNote(), 'dialog class-dialog');
}

export interface CardActions {
  isTeacher: boolean;
  isOwn: boolean;
  isHidden: boolean;
  isShown: boolean;
  spotlight(isShown: boolean): void;
  hide(isHidden: boolean): void;
  handBack(at: [number, number] | null, words: string): void;
  remix(): void;
  startEverybody(): void;
}

/** A picture with a mark where somebody pressed it. */
function markable(picture: HTMLImageElement): { element: HTMLElement; at(): [number, number] | null } {
  const mark = make('span', { class: 'class-mark', 'aria-hidden': 'true' });
  mark.hidden = true;
  const element = make('div', { class: 'class-picture' }, picture, mark);
  let at: [number, number] | null = null;
  picture.addEventListener('click', (event) => {
    const box = picture.getBoundingClientRect();
    at = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    putMark(mark, at);
  });
  return { element, at: () => at };
}

function putMark(mark: HTMLElement, [x, y]: [number, number]): void {
  mark.hidden = false;
  mark.style.left = `${100 * x}%`;
  mark.style.top = `${100 * y}%`;
}

/** One model of the wall, large, with what can be done with it. `picture` is its address. */
export function showCard(card: Card, maker: string, picture: string | null, actions: CardActions): void {
  const image = picture ? make('img', { src: picture, alt: '', width: '640', height: '640' }) : null;
  const marked = image && actions.isTeacher && card.seat !== null ? markable(image) : null;
  const body: Node[] = [];
  if (marked) body.push(marked.element);
  else if (image) body.push(make('div', { class: 'class-picture' }, image));
  const close = (act: () => void) => () => {
    dialog.close();
    act();
  };
  const buttons = make('div', { class: 'dialog-buttons class-buttons' });
  if (actions.isTeacher) {
    const { isShown, isHidden } = actions;
    buttons.append(
      iconButton(
        'eye',
        isShown ? 'Show the whole wall' : 'Show to all',
        close(() => actions.spotlight(!isShown)),
      ),
      iconButton(
        isHidden ? 'eye' : 'eye-off',
        isHidden ? 'Put on the wall again' : 'Hide',
        close(() => actions.hide(!isHidden)),
      ),
      iconButton(
        'send',
        'Start everybody with it',
        close(() => actions.startEverybody()),
      ),
    );
  }
  buttons.append(
    iconButton(
      'copy',
      actions.isOwn || actions.isTeacher ? 'Open a copy' : 'Remix',
      close(() => actions.remix()),
    ),
  );
  if (actions.isTeacher && card.seat !== null) {
    const words = make('input', { type: 'text', id: 'class-back', maxlength: '300', autocomplete: 'off' });
    const form = make(
      'form',
      { class: 'class-back' },
      make('label', { for: 'class-back' }, 'Press the picture to put a mark, and write a line:'),
      words,
      make(
        'div',
        { class: 'dialog-buttons' },
        make('button', { type: 'submit', class: 'button button-primary' }, 'Hand it back'),
      ),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      close(() => actions.handBack(marked?.at() ?? null, words.value.trim()))();
    });
    body.push(form);
  }
  body.push(buttons);
  const dialog = openDialog(`${maker} · ${card.name}`, body, 'dialog sheet class-card');
}

/** What the teacher handed back: the picture with the mark, and the words. */
export function showBack(
  back: { at: [number, number] | null; words: string },
  picture: string | null,
  openCopy: () => void,
): void {
  const body: Node[] = [];
  if (picture) {
    const mark = make('span', { class: 'class-mark', 'aria-hidden': 'true' });
    mark.hidden = true;
    if (back.at) putMark(mark, back.at);
    body.push(
      make(
        'div',
        { class: 'class-picture' },
        make('img', { src: picture, alt: '', width: '640', height: '640' }),
        mark,
      ),
    );
  }
  body.push(make('p', { class: 'class-words-back' }, asIs(back.words)));
  body.push(
    make(
      'div',
      { class: 'dialog-buttons' },
      iconButton('copy', 'Open it as I handed it in', () => {
        dialog.close();
        openCopy();
      }),
      iconButton('check', 'Go on', () => dialog.close(), 'button-primary'),
    ),
  );
  const dialog = openDialog('Your teacher handed your model back', body, 'dialog sheet class-card');
}
