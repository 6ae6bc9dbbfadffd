// The command bar: buttons and menus generated from the engine's command table, so that keyboard and
// screen-reader users reach everything that the canvas offers.
import type { Command } from './api.ts';
import { ariaShortcut, byId, firstShortcut, make, setAttribute, shortcutText } from './dom.ts';
import { icon } from './icons.ts';
import { hasOpenMenu, toggleMenu, updateMenu } from './menu.ts';
import type { MenuGroup, MenuItem } from './menu.ts';

type Run = (id: string, args?: Record<string, unknown>) => void;

/** Commands with a button of their own, in order; '|' is a line between groups. */
const kBar = [
  'open-picture',
  '|',
  'draw',
  'new-part',
  '|',
  'undo',
  'redo',
  '|',
  'set-section',
  'set-caps',
  'delete-part',
];
/** The headings of the menu in their order; others stand behind them. */
const kHeadings = ['Model', 'Pictures', 'Part', 'Together', 'Print', 'Help'];
/** What leaves the bar first when it is too narrow: the panel, or the More menu, has it as well. Undo stays. */
const kGivesWay = ['delete-part', 'set-caps', 'set-section', 'new-part', 'redo', 'open-picture'];
export class CommandBar {
  private readonly items = byId('bar-items');
  private readonly more = byId<HTMLButtonElement>('bar-more');
  private readonly help = byId<HTMLButtonElement>('bar-help');
  private readonly save = byId<HTMLButtonElement>('bar-save');
  private readonly saveWord = make('span', {}, 'Save');
  private readonly toolbar = byId('bar');
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private commands: Command[] = [];

  constructor(
    private readonly run: Run,
    /** The table with the choices as they are now. */
    private readonly allNow: () => Command[],
  ) {
    this.more.append(icon('ellipsis'), make('span', { class: 'bar-label' }, 'More'));
    this.help.append(icon('circle-question-mark'), make('span', { class: 'bar-label' }, 'Help'));
    this.help.addEventListener('click', () => this.run('help'));
    this.save.append(icon('download'), this.saveWord, icon('chevron-down'));
    this.more.addEventListener('click', () => toggleMenu(this.more, 'More', this.moreGroups()));
    this.save.addEventListener('click', () => this.openSaveMenu());
    this.toolbar.addEventListener('keydown', (event) => this.moveFocus(event));
    this.toolbar.addEventListener('focusin', (event) => this.remember(event.target as HTMLElement));
    new ResizeObserver(() => this.fit()).observe(this.toolbar);
  }

  /** Shows the table as it is now; focus stays, and so does an open menu. */
  update(commands: Command[]): void {
    this.commands = commands;
    if (this.buttons.size === 0) this.rebuild(kBar);
    for (const command of commands) this.updateButton(command);
    const savable = this.saveCommands().some((command) => command.enabled);
    setAttribute(this.save, 'aria-disabled', savable ? null : 'true');
    setAttribute(this.save, 'data-tip', savable ? 'Save the model as a file' : 'Draw a part first, then save it');
    if (hasOpenMenu(this.toolbar)) updateMenu(this.menuItems());
    this.fit();
  }

  private find(id: string): Command | undefined {
    return this.commands.find((command) => command.id === id);
  }

  private rebuild(ids: string[]): void {
    this.buttons.clear();
    this.items.replaceChildren(
      ...ids.map((id) => {
        if (id === '|') return make('span', { class: 'bar-line', role: 'separator', 'aria-orientation': 'vertical' });
        const button = make('button', { type: 'button', class: 'bar-button', tabindex: '-1', 'data-command': id });
        button.addEventListener('click', () => this.press(button, id));
        this.buttons.set(id, button);
        return button;
      }),
    );
    this.setStop(this.stops()[0]);
  }

  private updateButton(command: Command): void {
    const button = this.buttons.get(command.id);
    if (!button) return;
    const choices = command.argument?.choices;
    const shape = `${command.icon}|${command.label}|${choices ? 1 : 0}`;
    if (button.dataset.shape !== shape) {
      button.replaceChildren(icon(command.icon), make('span', { class: 'bar-label' }, command.label));
      if (choices) button.append(icon('chevron-down'));
      button.dataset.shape = shape;
    }
    setAttribute(button, 'aria-label', command.label);
    setAttribute(button, 'aria-disabled', command.enabled ? null : 'true');
    setAttribute(button, 'aria-keyshortcuts', command.shortcut ? ariaShortcut(command.shortcut) : null);
    setAttribute(button, 'data-tip', command.label);
    setAttribute(button, 'data-keys', command.shortcut ? shortcutText(firstShortcut(command.shortcut)) : null);
    if (choices) {
      setAttribute(button, 'aria-haspopup', 'menu');
      if (!button.hasAttribute('aria-expanded')) button.setAttribute('aria-expanded', 'false');
    } else if (typeof command.toggled === 'boolean') {
      setAttribute(button, 'aria-pressed', String(command.toggled));
    }
  }

  private press(button: HTMLElement, id: string): void {
    const command = this.find(id);
    if (!command?.enabled) return;
    if (command.argument?.choices)
      toggleMenu(button, command.label, [{ title: '', items: this.choiceItems(this.withChoices(command)) }]);
    else this.run(id);
  }

  private withChoices(command: Command): Command {
    return this.allNow().find(({ id }) => id === command.id) ?? command;
  }

  /** All items of all menus, as they are now. */
  private menuItems(): MenuItem[] {
    return this.allNow().flatMap((command) => [this.plainItem(command, false), ...this.choiceItems(command)]);
  }

  private choiceItems(command: Command): MenuItem[] {
    const argument = command.argument;
    return (argument?.choices ?? []).map((choice) => ({
      command: command.id,
      value: String(choice.value),
      label: choice.label,
      icon: choice.icon,
      swatch: /^#[0-9a-f]{6}$/i.test(String(choice.value)) ? String(choice.value) : undefined,
      kind: typeof choice.toggled === 'boolean' ? ('radio' as const) : undefined,
      checked: choice.toggled,
      disabled: !command.enabled,
      run: () => this.run(command.id, { [argument?.key ?? 'value']: choice.value }),
    }));
  }

  private saveCommands(): Command[] {
    return this.commands.filter(({ id }) => id.startsWith('save-') || id === 'share-model');
  }

  private openSaveMenu(): void {
    if (this.save.getAttribute('aria-disabled') === 'true') return;
    const items = (ours: boolean) =>
      this.saveCommands()
        .filter((command) => (command.group === 'model') === ours)
        .map((command) => this.plainItem(command, true));
    toggleMenu(this.save, 'Save', [
      { title: '', items: items(true) },
      { title: '', items: items(false) },
    ]);
  }

  private plainItem(command: Command, withHint: boolean): MenuItem {
    const toggled = typeof command.toggled === 'boolean';
    return {
      command: command.id,
      label: command.label,
      icon: command.icon,
      detail: withHint ? command.hint : undefined,
      shortcut: command.shortcut,
      disabled: !command.enabled,
      kind: toggled ? 'checkbox' : undefined,
      checked: command.toggled ?? undefined,
      run: () => this.run(command.id),
    };
  }

  /** A command with choices as one item that leads to them. */
  private leadingItem(command: Command): MenuItem {
    const choices = () =>
      toggleMenu(this.more, command.label, [
        { title: command.label, items: this.choiceItems(this.withChoices(command)) },
      ]);
    return {
      command: command.id,
      label: command.label,
      icon: command.icon,
      disabled: !command.enabled,
      leads: true,
      run: choices,
    };
  }

  /** What the table offers here and now, under its headings; what the bar shows is left out. */
  private moreGroups(): MenuGroup[] {
    const groups: MenuGroup[] = [];
    for (const command of this.allNow()) {
      const isShown = this.buttons.get(command.id)?.hidden === false;
      if (!command.menu || !command.enabled || isShown) continue;
      const item = command.argument?.choices ? this.leadingItem(command) : this.plainItem(command, false);
      const group = groups.find(({ title }) => title === command.menu);
      if (group) group.items.push(item);
      else groups.push({ title: command.menu, items: [item] });
    }
    const place = ({ title }: MenuGroup) => (kHeadings.includes(title) ? kHeadings.indexOf(title) : kHeadings.length);
    return groups.sort((a, b) => place(a) - place(b));
  }

  /** Shows what there is room for: after the buttons of kGivesWay the word on Save goes, then Help and Line. */
  private fit(): void {
    const button = (id: string) => this.buttons.get(id);
    const last = [this.saveWord, this.help, button('draw')];
    const giveWay = [...kGivesWay.map(button), ...last].filter((element) => element !== undefined);
    for (const element of giveWay) element.hidden = false;
    for (const element of giveWay) {
      if (this.items.scrollWidth <= this.items.clientWidth + 1) break;
      element.hidden = true;
    }
    const stop = this.toolbar.querySelector<HTMLElement>('[tabindex="0"]');
    if (!stop || stop.hidden) this.setStop(this.stops()[0]);
  }

  private stops(): HTMLElement[] {
    return [...this.toolbar.querySelectorAll<HTMLElement>('button')].filter((button) => !button.hidden);
  }

  private setStop(stop: HTMLElement | undefined): void {
    for (const button of this.toolbar.querySelectorAll('button')) button.tabIndex = button === stop ? 0 : -1;
  }

  private remember(target: HTMLElement): void {
    if (target instanceof HTMLButtonElement) this.setStop(target);
  }

  private moveFocus(event: KeyboardEvent): void {
    const stops = this.stops();
    const at = stops.indexOf(document.activeElement as HTMLElement);
    if (at < 0) return;
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: stops.length - 1 }[event.key];
    if (to === undefined) {
      if (event.key === 'ArrowDown' && document.activeElement?.hasAttribute('aria-haspopup')) {
        event.preventDefault();
        (document.activeElement as HTMLElement).click();
      }
      return;
    }
    event.preventDefault();
    stops[(to + stops.length) % stops.length]?.focus();
  }
}
