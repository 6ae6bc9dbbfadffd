// Dialogs in the DOM: text entry needs the soft keyboard and input methods, which a canvas lacks.
import { make, shortcutText } from './dom.ts';
import { icon } from './icons.ts';
import type { Command } from './api.ts';

export function openDialog(title: string, body: Node[], className: string): HTMLDialogElement {
  const heading = make('h2', { id: 'dialog-title' }, title);
  const close = make('button', { type: 'button', class: 'dialog-close', 'aria-label': 'Close' });
  close.append(icon('x'));
  const dialog = make(
    'dialog',
    { class: className, 'aria-labelledby': 'dialog-title' },
    make('header', {}, heading, close),
    ...body,
  );
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close(); // on the backdrop
  });
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

/** Asks for a line of text, for a command; null when it was closed without an answer. */
export function askText(title: string, text: string, value = '', command?: string): Promise<string | null> {
  const input = make('input', { type: 'text', id: 'dialog-input', value, autocomplete: 'off', maxlength: '200' });
  const form = make(
    'form',
    { method: 'dialog' },
    make('label', { for: 'dialog-input' }, text),
    input,
    make(
      'div',
      { class: 'dialog-buttons' },
      make('button', { type: 'button', class: 'button', value: 'cancel' }, 'Cancel'),
      make('button', { type: 'submit', class: 'button button-primary', 'data-command': command }, 'OK'),
    ),
  );
  const dialog = openDialog(title, [form], 'dialog');
  input.select();
  return new Promise((resolve) => {
    let answer: string | null = null;
    form.addEventListener('submit', () => {
      answer = input.value;
    });
    form.querySelector('[value=cancel]')?.addEventListener('click', () => dialog.close());
    dialog.addEventListener('close', () => resolve(answer));
  });
}

/** Asks a question with buttons; the value of the one that was pressed, null when it was closed. */
export function askChoice(
  title: string,
  text: string,
  choices: { value: string; label: string; command?: string }[],
): Promise<string | null> {
  const buttons = choices.map(({ value, label, command }, i) => {
    const look = i === 0 ? 'button button-primary' : 'button';
    return make('button', { type: 'button', class: look, value, 'data-command': command }, label);
  });
  const dialog = openDialog(
    title,
    [make('p', {}, text), make('div', { class: 'dialog-buttons' }, ...buttons.reverse())],
    'dialog',
  );
  return new Promise((resolve) => {
    let answer: string | null = null;
    for (const button of buttons) {
      button.addEventListener('click', () => {
        answer = button.value;
        dialog.close();
      });
    }
    dialog.addEventListener('close', () => resolve(answer));
  });
}

const kPointerHelp: [string, string][] = [
  ['Draw', 'Drag with the left button, a finger or a pen on the picture'],
  ['Ribs', 'Drag an end; the wheel, [ and ] change how far its neighbours follow. Tap a grey dot to take that edge'],
  ['Bone', 'Drag a point, an end or the line, or draw a new line; in the solid view drag a point nearer or farther'],
  ['Take back a gesture', 'Escape, the right button or a second finger, before you let go'],
  ['Turn the solid', 'Drag in the solid view, or Alt + drag'],
  ['Move the view', 'Shift + middle button, or two fingers'],
  ['Zoom', 'Wheel, or pinch'],
  ['Undo, redo', 'Tap with two fingers, three fingers'],
];

/** The tables of the sheet, and the groups of commands in each. */
const kSheetGroups = [
  { title: 'Tools', groups: ['tool', 'draw'] },
  { title: 'Ribs', groups: ['ribs'] },
  { title: 'Bone', groups: ['bone'] },
  { title: 'Places', groups: ['place'] },
  { title: 'Part and slice', groups: ['part', 'slice', 'board', 'section', 'caps', 'look'] },
  { title: 'Edit', groups: ['edit', 'history'] },
  { title: 'File', groups: ['file', 'picture', 'model'] },
  { title: 'View', groups: ['view', 'help'] },
];

/** The sheet of all shortcuts, from the command table. */
export function showShortcutSheet(commands: Command[]): void {
  if (document.querySelector('dialog.sheet')) return;
  const row = (what: string, keys: Node, hint = '') =>
    make('tr', {}, make('th', { scope: 'row' }, what), make('td', {}, keys), make('td', { class: 'sheet-hint' }, hint));
  const kbd = (shortcut: string) => {
    const span = make('span', {});
    const keys = shortcut.split(', ');
    const arrows = keys.filter((key) => key.includes('Arrow'));
    const shown = arrows.length > 4 ? ['Arrows', 'Shift+Arrows', ...keys.filter((key) => !arrows.includes(key))] : keys;
    for (const key of shown) span.append(make('kbd', {}, shortcutText(key)), ' ');
    return span;
  };
  const tables = kSheetGroups.map(({ title, groups }) => {
    const rows = commands
      .filter((command) => command.shortcut && groups.includes(command.group))
      .map((command) => row(command.label, kbd(command.shortcut), command.hint ?? ''));
    if (title === 'Tools')
      rows.push(
        row('Draw with keys', kbd('Enter'), 'On the picture: arrows move the pen, Space puts it down and lifts it'),
      );
    if (title === 'View') rows.push(row('This sheet', kbd('?')));
    return make('table', {}, make('caption', {}, title), make('tbody', {}, ...rows));
  });
  const handRows = kPointerHelp.map(([what, how]) =>
    make('tr', {}, make('th', { scope: 'row' }, what), make('td', { colspan: '2' }, how)),
  );
  openDialog(
    'Keys and gestures',
    [
      make(
        'div',
        { class: 'sheet-body', tabindex: '0', role: 'region', 'aria-label': 'List of keys and gestures' },
        ...tables,
        make('table', {}, make('caption', {}, 'Mouse, finger and pen'), make('tbody', {}, ...handRows)),
      ),
    ],
    'dialog sheet',
  );
}
