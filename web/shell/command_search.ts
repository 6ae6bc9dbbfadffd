// The search over all commands: a text field and the list of those that it finds, after the ARIA combobox pattern.
import type { Command } from './api.ts';
import { openDialog } from './dialogs.ts';
import { firstShortcut, make, setAttribute, shortcutText } from './dom.ts';
import { choicesOf, findCommands } from './find_commands.ts';
import type { Found } from './find_commands.ts';
import { icon } from './icons.ts';
import { leadsOn } from './menu.ts';
import { t } from './words/words.ts';

const kMost = 60;

function option(found: Found, at: number): HTMLElement {
  const { command, label } = found;
  const line = make('div', {
    class: 'menu-item',
    role: 'option',
    id: `command-${at}`,
    'data-command': command.id,
    'aria-disabled': command.enabled ? undefined : 'true',
  });
  const words = make('span', { class: 'menu-words' }, make('span', { class: 'menu-label' }, label));
  const hint = t(command.hint ?? '');
  const detail = command.enabled ? hint : t('{hint}. Not possible right now', { hint });
  if (detail) words.append(make('span', { class: 'menu-detail' }, detail));
  line.append(icon(command.icon), words);
  if (command.shortcut && !found.args) line.append(make('kbd', {}, shortcutText(firstShortcut(command.shortcut))));
  if (found.leads) line.append(leadsOn());
  return line;
}

/** Opens the search; `run` is told what was chosen. */
export function openCommandSearch(
  commands: readonly Command[],
  run: (id: string, args?: Record<string, unknown>) => void,
): void {
  if (document.querySelector('dialog.search')) return;
  const input = make('input', {
    type: 'text',
    role: 'combobox',
    'aria-expanded': 'true',
    'aria-controls': 'search-list',
    'aria-autocomplete': 'list',
    'aria-label': 'What do you want to do?',
    placeholder: 'What do you want to do?',
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const list = make('div', { id: 'search-list', class: 'search-list', role: 'listbox', 'aria-label': 'Commands' });
  const none = make('p', { class: 'search-none', role: 'status' });
  const dialog = openDialog('Find a command', [input, list, none], 'dialog search');
  let found: Found[] = [];
  let chosen = 0;
  const choose = (at: number) => {
    chosen = found.length > 0 ? (at + found.length) % found.length : 0;
    [...list.children].forEach((line, i) => setAttribute(line, 'aria-selected', String(i === chosen)));
    setAttribute(input, 'aria-activedescendant', found.length > 0 ? `command-${chosen}` : null);
    list.children[chosen]?.scrollIntoView({ block: 'nearest' });
  };
  const accept = (at: number) => {
    const one = found[at];
    if (!one?.command.enabled) return;
    if (one.leads) {
      input.value = one.label;
      show(choicesOf(one.command));
      input.focus();
      return;
    }
    dialog.close();
    run(one.command.id, one.args);
  };
  const show = (lines: Found[]) => {
    found = lines.slice(0, kMost);
    list.replaceChildren(...found.map(option));
    [...list.children].forEach((line, i) => line.addEventListener('click', () => accept(i)));
    none.textContent = found.length === 0 ? t('Nothing is called that. Try another word.') : '';
    list.scrollTop = 0;
    choose(0);
  };
  const search = () => show(findCommands(commands, input.value));
  input.addEventListener('input', search);
  input.addEventListener('keydown', (event) => {
    const to = { ArrowDown: chosen + 1, ArrowUp: chosen - 1 }[event.key];
    if (to !== undefined) choose(to);
    else if (event.key === 'Enter') accept(chosen);
    else return;
    event.preventDefault();
  });
  search();
  input.focus();
}
