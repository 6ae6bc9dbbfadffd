// "Your models": what this device keeps, as a strip on the start page and as a dialog for all of them.
import { openDialog } from '../dialogs.ts';
import { asIs, byId, make } from '../dom.ts';
import { icon } from '../icons.ts';
import { toggleMenu } from '../menu.ts';
import type { MenuItem } from '../menu.ts';
import { animalOf } from './animals.ts';
import type { ModelInfo } from './store.ts';
import { nameText } from '../words/names.ts';
import { language, t } from '../words/words.ts';

/** What can be done with a model of the list. */
export interface ModelActions {
  list(): Promise<ModelInfo[]>;
  /** Ids of models that other tabs have open. */
  elsewhere(): Promise<Set<string>>;
  current(): string | null;
  open(id: string): void;
  duplicate(id: string): void;
  rename(id: string): void;
  remove(id: string): void;
  nextPupil(): void;
}

const kOnStartPage = 12;

/** "today, 14:05", "yesterday, 9:12" or a date. */
export function whenText(time: number, now: number): string {
  const day = (at: number) => new Date(at).setHours(0, 0, 0, 0);
  const days = Math.round((day(now) - day(time)) / 86_400_000);
  const clock = new Date(time).toLocaleTimeString(language().id, { hour: 'numeric', minute: '2-digit' });
  if (days === 0) return t('today, {clock}', { clock });
  if (days === 1) return t('yesterday, {clock}', { clock });
  return new Date(time).toLocaleDateString(language().id, { day: 'numeric', month: 'short', year: 'numeric' });
}

function countText(model: ModelInfo): string {
  if (model.parts > 0) return model.parts === 1 ? t('1 part') : t('{n} parts', { n: model.parts });
  return model.pictures > 0 ? t('no part yet') : t('empty');
}

export class ModelsView {
  private readonly strip = byId('models');
  private readonly cards = byId('models-cards');
  private readonly addresses = new Set<string>();
  private dialog: { element: HTMLDialogElement; list: HTMLElement } | null = null;
  private drawn = '';
  private drawing = false;
  private again = false;

  constructor(private readonly actions: ModelActions) {
    const all = byId('models-all');
    all.addEventListener('click', () => this.showAll());
    byId('models-next').addEventListener('click', () => this.actions.nextPupil());
  }

  /** Shows the list as it is now; quick to call often. */
  async update(): Promise<void> {
    const visible = !byId('start').hidden || this.dialog !== null;
    if (!visible) return;
    if (this.drawing) {
      this.again = true;
      return;
    }
    this.drawing = true;
    do {
      this.again = false;
      const [models, elsewhere] = await Promise.all([this.actions.list(), this.actions.elsewhere()]);
      this.draw(models, elsewhere);
    } while (this.again);
    this.drawing = false;
  }

  /** The dialog with all models. */
  showAll(): void {
    if (this.dialog) return;
    const list = make('ul', { class: 'models-grid' });
    const element = openDialog(
      'Your models',
      [make('div', { class: 'sheet-body' }, list)],
      'dialog sheet models-dialog',
    );
    this.dialog = { element, list };
    this.drawn = '';
    element.addEventListener('close', () => {
      this.dialog = null;
    });
    void this.update();
  }

  private draw(models: ModelInfo[], elsewhere: Set<string>): void {
    const current = this.actions.current();
    const key = JSON.stringify([
      models.map((model) => [
        model.id,
        model.name,
        model.modified,
        model.parts,
        model.thumbnail?.bytes.length,
        model.whose,
      ]),
      [...elsewhere],
      current,
      language().id,
      this.dialog !== null,
    ]);
    if (key === this.drawn) return;
    this.drawn = key;
    for (const address of this.addresses) URL.revokeObjectURL(address);
    this.addresses.clear();
    const card = (model: ModelInfo) => this.card(model, model.id === current, elsewhere.has(model.id));
    this.strip.hidden = models.length === 0;
    this.cards.replaceChildren(...models.slice(0, kOnStartPage).map(card));
    byId('models-next').hidden = models.every((model) => animalOf(model.whose ?? null));
    byId('models-all').hidden = models.length <= kOnStartPage;
    if (!this.dialog) return;
    const { list } = this.dialog;
    list.replaceChildren(...models.map(card));
    if (models.length === 0)
      list.append(
        make('li', { class: 'models-none' }, 'Nothing here yet. What you draw is kept on this device by itself.'),
      );
  }

  private card(model: ModelInfo, isOpen: boolean, isElsewhere: boolean): HTMLElement {
    const frame = make('span', { class: 'model-frame' });
    if (model.thumbnail) frame.append(this.picture(model.thumbnail));
    else frame.append(icon('box'));
    const where = isElsewhere ? t('in another tab') : isOpen ? t('open') : '';
    if (where) frame.append(make('span', { class: 'model-badge' }, where));
    const animal = animalOf(model.whose ?? null);
    if (animal) {
      const badge = make('span', { class: 'model-badge model-animal' }, t(animal.name));
      badge.prepend(icon(animal.id));
      frame.append(badge);
    }
    const detail = `${countText(model)} · ${whenText(model.modified, Date.now())}`;
    const button = make(
      'button',
      { type: 'button', class: 'model-open', 'data-command': 'open-model' },
      frame,
      make('span', { class: 'model-name', dir: 'auto' }, asIs(nameText(model.name))),
      make('span', { class: 'model-detail' }, detail),
    );
    button.addEventListener('click', () => {
      this.dialog?.element.close();
      this.actions.open(model.id);
    });
    const more = make('button', {
      type: 'button',
      class: 'model-more',
      'aria-haspopup': 'menu',
      'aria-expanded': 'false',
      'aria-label': t('More about {name}', { name: nameText(model.name) }),
    });
    more.append(icon('ellipsis-vertical'));
    more.addEventListener('click', () =>
      toggleMenu(more, nameText(model.name), [{ title: '', items: this.menu(model, isElsewhere) }]),
    );
    return make('li', { class: 'model', 'data-model': model.id }, button, more);
  }

  private menu(model: ModelInfo, isElsewhere: boolean): MenuItem[] {
    const { id } = model;
    const open = () => {
      this.dialog?.element.close();
      this.actions.open(id);
    };
    return [
      { command: 'open-model', label: 'Open', icon: 'folder-open', run: open },
      { command: 'duplicate-model', label: 'Duplicate', icon: 'copy', run: () => this.actions.duplicate(id) },
      {
        command: 'rename-model',
        label: 'Rename',
        icon: 'pencil-line',
        disabled: isElsewhere,
        run: () => this.actions.rename(id),
      },
      {
        command: 'delete-model',
        label: 'Delete',
        icon: 'trash-2',
        disabled: isElsewhere,
        run: () => this.actions.remove(id),
      },
    ];
  }

  private picture(thumbnail: NonNullable<ModelInfo['thumbnail']>): HTMLImageElement {
    const address = URL.createObjectURL(new Blob([thumbnail.bytes as BlobPart], { type: thumbnail.type }));
    this.addresses.add(address);
    return make('img', { src: address, alt: '', width: '208', height: '156', decoding: 'async' });
  }
}
