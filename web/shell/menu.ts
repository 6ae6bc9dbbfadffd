// A popup menu after the ARIA menu-button pattern: arrows, Home, End, first letters, Escape.
import { firstShortcut, make, setAttribute, shortcutText } from './dom.ts';
import { icon } from './icons.ts';

export interface MenuItem {
  label: string;
  /** Id of the command that it runs, and which of its choices it gives; both are on the element. */
  command?: string | undefined;
  value?: string | undefined;
  icon?: string | undefined;
  detail?: string | undefined;
  shortcut?: string | undefined;
  disabled?: boolean | undefined;
  /** Makes it a radio or a checkbox item. */
  checked?: boolean | undefined;
  kind?: 'radio' | 'checkbox' | undefined;
  /** A colour to show in place of an icon. */
  swatch?: string | undefined;
  /** It leads to another menu at the same place. */
  leads?: boolean | undefined;
  run(): void;
}

/** Items under a heading; an empty title shows only a line. */
export interface MenuGroup {
  title: string;
  items: MenuItem[];
}

let openMenu: { close(refocus: boolean): void; anchor: HTMLElement; element: HTMLElement } | null = null;

/** Closes the open menu, if any. */
export function closeMenu(): void {
  openMenu?.close(false);
}

/** Whether a menu of a button in this element is open. */
export function hasOpenMenu(bar: HTMLElement): boolean {
  return openMenu !== null && bar.contains(openMenu.anchor);
}

/** Brings the open menu up to date with these items; focus stays. */
export function updateMenu(items: Pick<MenuItem, 'command' | 'value' | 'disabled' | 'checked'>[]): void {
  for (const element of openMenu?.element.querySelectorAll<HTMLElement>('[data-command]') ?? []) {
    const { command, value } = element.dataset;
    const item = items.find((candidate) => candidate.command === command && candidate.value === value);
    if (!item) continue;
    setAttribute(element, 'aria-disabled', item.disabled ? 'true' : null);
    if (element.hasAttribute('aria-checked')) setAttribute(element, 'aria-checked', String(item.checked === true));
  }
}

/** The arrow of a line that leads to others; it points the way that the page is read. */
export function leadsOn(): SVGElement {
  const arrow = icon('chevron-right');
  arrow.classList.add('leads-on');
  return arrow;
}

function itemElement(item: MenuItem): HTMLElement {
  const role = item.kind ? `menuitem${item.kind}` : 'menuitem';
  const element = make('div', {
    class: 'menu-item',
    role,
    tabindex: '-1',
    'data-command': item.command,
    'data-value': item.value,
    'aria-haspopup': item.leads ? 'menu' : undefined,
    'aria-disabled': item.disabled ? 'true' : undefined,
    'aria-checked': item.kind ? String(item.checked === true) : undefined,
  });
  if (item.icon) element.append(icon(item.icon));
  if (item.swatch) {
    const swatch = make('span', { class: 'menu-swatch' });
    swatch.style.backgroundColor = item.swatch;
    element.append(swatch);
  }
  const words = make('span', { class: 'menu-words' }, make('span', { class: 'menu-label' }, item.label));
  if (item.detail) words.append(make('span', { class: 'menu-detail' }, item.detail));
  element.append(words);
  if (item.shortcut) element.append(make('kbd', {}, shortcutText(firstShortcut(item.shortcut))));
  if (item.leads) element.append(leadsOn());
  return element;
}

function place(menu: HTMLElement, anchor: HTMLElement): void {
  const at = anchor.getBoundingClientRect();
  const room = 8;
  const left = Math.min(at.left, innerWidth - menu.offsetWidth - room);
  menu.style.left = `${Math.max(room, left)}px`;
  menu.style.top = `${at.bottom + 6}px`;
  menu.style.maxHeight = `${Math.max(160, innerHeight - at.bottom - 6 - room)}px`;
}

function handleKeys(event: KeyboardEvent, elements: HTMLElement[], close: (refocus: boolean) => void): void {
  const at = elements.indexOf(document.activeElement as HTMLElement);
  const go = (index: number) => elements[(index + elements.length) % elements.length]?.focus();
  switch (event.key) {
    case 'ArrowDown':
      go(at + 1);
      break;
    case 'ArrowUp':
      go(at - 1);
      break;
    case 'Home':
      go(0);
      break;
    case 'End':
      go(elements.length - 1);
      break;
    case 'Escape':
      close(true);
      break;
    case 'Tab':
      close(true);
      return;
    case document.dir === 'rtl' ? 'ArrowLeft' : 'ArrowRight':
      if (elements[at]?.hasAttribute('aria-haspopup')) elements[at]?.click();
      break;
    case 'Enter':
    case ' ':
      elements[at]?.click();
      break;
    default: {
      if (event.key.length !== 1 || event.ctrlKey || event.metaKey) return;
      const order = [...elements.slice(at + 1), ...elements.slice(0, at + 1)];
      order.find((element) => element.textContent?.trim().toLowerCase().startsWith(event.key.toLowerCase()))?.focus();
    }
  }
  event.preventDefault();
  event.stopPropagation();
}

/** Opens a menu under its button, or closes it when it is open there. */
export function toggleMenu(anchor: HTMLElement, label: string, groups: MenuGroup[]): void {
  const same = openMenu?.anchor === anchor;
  closeMenu();
  if (same) return;
  const menu = make('div', { class: 'menu', role: 'menu', 'aria-label': label });
  const elements: HTMLElement[] = [];
  const close = (refocus: boolean) => {
    menu.remove();
    anchor.setAttribute('aria-expanded', 'false');
    document.removeEventListener('pointerdown', outside, true);
    openMenu = null;
    if (refocus) anchor.focus();
  };
  const outside = (event: Event) => {
    const target = event.target as Node;
    if (!menu.contains(target) && !anchor.contains(target)) close(false);
  };
  for (const group of groups.filter((candidate) => candidate.items.length > 0)) {
    const box = make('div', { role: 'group', class: 'menu-group', 'aria-label': group.title || undefined });
    if (group.title) box.append(make('div', { class: 'menu-title', 'aria-hidden': 'true' }, group.title));
    for (const item of group.items) {
      const element = itemElement(item);
      element.addEventListener('click', () => {
        if (element.getAttribute('aria-disabled') === 'true') return;
        close(true);
        item.run();
      });
      element.addEventListener('pointerenter', () => element.focus({ preventScroll: true }));
      elements.push(element);
      box.append(element);
    }
    menu.append(box);
  }
  menu.addEventListener('keydown', (event) => handleKeys(event, elements, close));
  // A modal dialog lets nothing outside of it be touched.
  (anchor.closest('dialog') ?? document.body).append(menu);
  place(menu, anchor);
  anchor.setAttribute('aria-expanded', 'true');
  document.addEventListener('pointerdown', outside, true);
  openMenu = { close, anchor, element: menu };
  // A list of choices opens at the one that is chosen, any other menu at its top.
  const chosen = elements.find((element) => element.matches('[role=menuitemradio][aria-checked=true]'));
  (chosen ?? elements[0])?.focus();
}
