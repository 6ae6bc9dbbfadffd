// What the panels on the canvas show, once more in the DOM: names, values and states for screen readers, and keys for
// all of it. Each element lies where its control is; one of them is in the order of Tab, arrows go to the others.
import type { Control } from './api.ts';
import { byId, make, setAttribute } from './dom.ts';
import { putOver } from './text_size.ts';
import { t } from './words/words.ts';

export interface MirroredPanels {
  press(control: Control): void;
  set(id: number, value: number): void;
  /** Its panel brings it into sight. */
  show(id: number): void;
  /** A name that the engine gave, in the visitor's language. */
  nameText(name: string): string;
}

interface Mirrored {
  control: Control;
  element: HTMLElement;
}

/** Words of a control in the visitor's language: a text of the catalogue, or several with commas between them. */
function said(words: string): string {
  const whole = t(words);
  return whole === words
    ? words
        .split(', ')
        .map((one) => t(one))
        .join(', ')
    : whole;
}

/** How far a key moves a slider, of its length. */
const kSliderSteps = 50;

export class Mirror {
  private readonly root = byId('mirror');
  private shown: Mirrored[] = [];

  constructor(private readonly panels: MirroredPanels) {
    this.root.addEventListener('keydown', (event) => this.key(event));
    this.root.addEventListener('focusin', (event) => {
      const mirrored = this.shown.find(({ element }) => element === event.target);
      if (!mirrored) return;
      this.putInTabOrder(mirrored.element);
      if (!mirrored.control.inSight) this.panels.show(mirrored.control.id);
    });
  }

  /** Elements stay for as long as their controls do, with the focus on them. */
  update(controls: Control[]): void {
    const focused = this.shown.findIndex(({ element }) => element === document.activeElement);
    const before = new Map(this.shown.map(({ control, element }) => [keyOf(control), element]));
    this.shown = controls
      // What a row is dragged by is for pointers; its part moves by commands.
      .filter(({ kind }) => kind !== 'grip')
      .map((control) => {
        const key = keyOf(control);
        const element = before.get(key) ?? this.makeFor(control);
        before.delete(key);
        this.tell(element, control);
        return { control, element };
      });
    this.arrange();
    const worked = this.worked();
    // What was focused and is gone hands the focus on to what is in its place.
    if (focused >= 0 && !this.root.contains(document.activeElement)) {
      worked[Math.min(focused, worked.length - 1)]?.focus({ preventScroll: true });
    }
    const inOrder = worked.find((element) => element.tabIndex === 0) ?? worked[0];
    if (inOrder) this.putInTabOrder(inOrder);
  }

  /** Puts the elements into their order; one that stays where it is keeps the focus. */
  private arrange(): void {
    const wanted = new Set<Element>(this.shown.map(({ element }) => element));
    for (const child of [...this.root.children]) if (!wanted.has(child)) child.remove();
    let next = this.root.firstElementChild;
    for (const { element } of this.shown) {
      if (element === next) next = next.nextElementSibling;
      else this.root.insertBefore(element, next);
    }
  }

  /** The elements that can be focused. */
  private worked(): HTMLElement[] {
    return this.shown.filter(({ control }) => control.kind !== 'words').map(({ element }) => element);
  }

  private putInTabOrder(element: HTMLElement): void {
    for (const each of this.worked()) each.tabIndex = each === element ? 0 : -1;
  }

  private makeFor(control: Control): HTMLElement {
    if (control.kind === 'words') return make('p', {});
    const current = () => this.shown.find((mirrored) => mirrored.element === element)?.control;
    let element: HTMLElement;
    if (control.slide) {
      const input = make('input', { type: 'range', tabindex: '-1' });
      input.addEventListener('change', () => {
        const now = current();
        if (now) this.panels.set(now.id, Number(input.value));
      });
      element = input;
    } else {
      element = make('button', { type: 'button', tabindex: '-1' });
      element.addEventListener('click', () => {
        const now = current();
        if (now?.enabled) this.panels.press(now);
      });
    }
    return element;
  }

  /** Name, value, state and place. */
  private tell(element: HTMLElement, control: Control): void {
    const { kind, words, on, enabled, command, slide } = control;
    putOver(element, control.at);
    if (kind === 'words') {
      const text = said(words);
      if (element.textContent !== text) element.textContent = text;
      return;
    }
    setAttribute(element, 'aria-label', kind === 'row' ? this.panels.nameText(words) : said(words));
    setAttribute(element, 'aria-disabled', enabled ? null : 'true');
    setAttribute(element, 'data-command', command);
    if (slide && element instanceof HTMLInputElement) {
      const { low, high, value, text } = slide;
      Object.assign(element, { min: String(low), max: String(high), step: String((high - low) / kSliderSteps) });
      element.value = String(value);
      setAttribute(element, 'aria-valuetext', text);
      return;
    }
    const isChoice = on || kind === 'row' || kind === 'tab' || kind === 'rib';
    setAttribute(element, 'aria-expanded', kind === 'section' ? String(on) : null);
    setAttribute(element, 'aria-pressed', kind !== 'section' && isChoice ? String(on) : null);
  }

  private key(event: KeyboardEvent): void {
    const worked = this.worked();
    const at = worked.indexOf(event.target as HTMLElement);
    if (at < 0) return;
    const isSlider = event.target instanceof HTMLInputElement;
    const steps: Record<string, number> = { ArrowDown: 1, ArrowUp: -1 };
    if (!isSlider) Object.assign(steps, { ArrowRight: 1, ArrowLeft: -1 });
    const step = steps[event.key];
    const end = event.key === 'Home' ? 0 : event.key === 'End' ? worked.length - 1 : null;
    const to = step !== undefined ? at + step : end;
    if (to === null) return;
    event.preventDefault();
    worked[(to + worked.length) % worked.length]!.focus({ preventScroll: true });
  }
}

/** The same for a control that is still there, also where it moved. */
function keyOf({ kind, id, words }: Control): string {
  return kind === 'words' ? `words ${words}` : `${kind} ${id}`;
}
