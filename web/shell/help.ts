// Help: things to make, the gestures of this device, and the keys of the command table.
import type { Command } from './api.ts';
import { openDialog } from './dialogs.ts';
import { asIs, make, shortcutText } from './dom.ts';
import { icon } from './icons.ts';
import { toggleMenu } from './menu.ts';
import { kTasks } from './tasks.ts';
import type { Task } from './tasks.ts';
import { kLanguages, language, t } from './words/words.ts';

type Rows = [what: string, how: string][];

const kFingers: Rows = [
  ['Draw', 'One finger on the picture'],
  ['Turn the solid', 'One finger in the solid view'],
  ['Move and zoom', 'Two fingers'],
  ['Undo, redo', 'Tap with two fingers, three fingers'],
  ['Take back a gesture', 'Put down a second finger before you let go'],
  ['Take more parts', 'Keep a finger on a row of the list'],
  ['Ribs', 'Drag an end. Tap a grey dot to take that edge'],
];
const kMouse: Rows = [
  ['Draw', 'Drag with the left button, or a pen, on the picture'],
  ['Turn the solid', 'Drag in the solid view, or Alt and drag'],
  ['Move the view', 'Shift and the middle button'],
  ['Zoom', 'The wheel'],
  ['Take back a gesture', 'Escape or the right button before you let go'],
  ['Take more parts', 'Shift and a click'],
  ['Ribs', 'Drag an end; the wheel, [ and ] change how far its neighbours follow. Tap a grey dot to take that edge'],
  ['Bone', 'Drag a point, an end or the line, or draw a new line; in the solid view drag a point nearer or farther'],
];

/** The tables of keys, and the groups of commands in each. */
const kKeyGroups = [
  { title: 'Tools', groups: ['tool', 'draw'] },
  { title: 'Ribs', groups: ['ribs'] },
  { title: 'Bone', groups: ['bone'] },
  { title: 'Places', groups: ['place'] },
  { title: 'Part and slice', groups: ['part', 'slice', 'board', 'section', 'caps', 'look'] },
  { title: 'Edit', groups: ['edit', 'history'] },
  { title: 'File', groups: ['file', 'picture', 'model'] },
  { title: 'View', groups: ['view', 'help'] },
];

function keysOf(shortcut: string): HTMLElement {
  const span = make('span', {});
  const keys = shortcut.split(', ');
  const arrows = keys.filter((key) => key.includes('Arrow'));
  const shown = arrows.length > 4 ? ['Arrows', 'Shift+Arrows', ...keys.filter((key) => !arrows.includes(key))] : keys;
  for (const key of shown) span.append(make('kbd', {}, asIs(shortcutText(key))), ' ');
  return span;
}

function keyTables(commands: readonly Command[]): HTMLElement[] {
  const row = (what: string, keys: string, hint = '') =>
    make(
      'tr',
      {},
      make('th', { scope: 'row' }, what),
      make('td', {}, keysOf(keys)),
      make('td', { class: 'sheet-hint' }, hint),
    );
  return kKeyGroups.map(({ title, groups }) => {
    const rows = commands
      .filter((command) => command.shortcut && groups.includes(command.group))
      .map((command) => row(command.label, command.shortcut, command.hint ?? ''));
    if (title === 'Tools')
      rows.push(row('Draw with keys', 'Enter', 'On the picture: arrows move the pen, Space puts it down and lifts it'));
    return make('table', {}, make('caption', {}, title), make('tbody', {}, ...rows));
  });
}

function gestures(rows: Rows): HTMLElement {
  const lines = rows.map(([what, how]) => make('tr', {}, make('th', { scope: 'row' }, what), make('td', {}, how)));
  return make('table', {}, make('tbody', {}, ...lines));
}

/** What Help tells and begins. */
export interface HelpPage {
  commands: readonly Command[];
  /** Sentences about the model that is open. */
  facts: string[];
  /** Begins a task; null: the steps of the first visit, once more. */
  begin(task: Task | null): void;
  /** Speaks another language. */
  choose(id: string): void;
}

/** A button that opens the list of languages. */
function languages(choose: (id: string) => void): HTMLElement {
  const button = make(
    'button',
    { type: 'button', class: 'button', 'data-command': 'language', 'aria-haspopup': 'menu', 'aria-expanded': 'false' },
    icon('languages'),
    asIs(language().name),
  );
  button.addEventListener('click', () => openLanguages(button, choose));
  return button;
}

/** The list of languages under its button. */
export function openLanguages(button: HTMLElement, choose: (id: string) => void): void {
  const items = kLanguages.map(({ id, name }) => ({
    command: 'language',
    value: id,
    label: name,
    kind: 'radio' as const,
    checked: id === language().id,
    run: () => choose(id),
  }));
  toggleMenu(button, 'Language', [{ title: '', items }]);
}

/** What can be made, each with its steps behind its name. */
function tasks(begin: (task: Task) => void): HTMLElement {
  const list = make('ul', { class: 'help-tasks' });
  for (const task of kTasks) {
    const steps = task.steps.map((step) => make('li', {}, step.say));
    const start = make('button', { type: 'button', class: 'button', value: task.id }, 'Make one');
    start.addEventListener('click', () => begin(task));
    const minutes = make('span', { class: 'help-minutes' }, ` ${t('about {n} minutes', { n: task.minutes })}`);
    const more = make('details', {}, make('summary', {}, task.title, minutes), make('p', {}, task.start));
    more.append(make('ol', {}, ...steps));
    list.append(make('li', {}, more, start));
  }
  return list;
}

/** What few look for, behind its heading. */
function folded(title: string, inside: HTMLElement[], open: boolean): HTMLElement {
  return make('details', { class: 'help-more', open }, make('summary', {}, make('h3', {}, title)), ...inside);
}

/** Opens Help; nothing while it is open. */
export function showHelp(page: HelpPage): void {
  if (document.querySelector('dialog.sheet')) return;
  const begin = (task: Task | null) => {
    dialog.close();
    page.begin(task);
  };
  const choose = (id: string) => {
    dialog.close();
    page.choose(id);
  };
  const again = make('button', { type: 'button', class: 'button', value: 'again' }, 'Show me again');
  again.addEventListener('click', () => begin(null));
  const touches = matchMedia('(pointer: coarse)').matches;
  const facts = page.facts.map((fact) => make('p', {}, fact));
  const body = make(
    'div',
    { class: 'sheet-body', tabindex: '0', role: 'region', 'aria-label': 'Help' },
    make('h3', {}, 'Things to make'),
    tasks(begin),
    again,
    make('h3', {}, touches ? 'With fingers' : 'With mouse and pen'),
    gestures(touches ? kFingers : kMouse),
    folded('With keys', keyTables(page.commands), !touches),
    make('h3', {}, 'Language'),
    languages(choose),
    ...(facts.length > 0 ? [folded('More about this model', facts, false)] : []),
  );
  const dialog = openDialog('Help', [body], 'dialog sheet');
}
