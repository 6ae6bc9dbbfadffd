// One tooltip for all buttons: on hover after a moment, on keyboard focus at once, under a finger that stays.
import { make } from './dom.ts';

const kDelayMs = 450,
  kStayMs = 500;

/** Elements with `data-tip` (and `data-keys`) get a tooltip; it only repeats what aria already says. */
export function connectTooltips(root: HTMLElement): void {
  const bubble = make('div', { class: 'tooltip', 'aria-hidden': 'true', hidden: true });
  document.body.append(bubble);
  let timer = 0;
  const hide = () => {
    clearTimeout(timer);
    bubble.hidden = true;
  };
  const show = (anchor: HTMLElement) => {
    bubble.replaceChildren(make('span', {}, anchor.dataset.tip ?? ''));
    if (anchor.dataset.keys) bubble.append(make('kbd', {}, anchor.dataset.keys));
    bubble.hidden = false;
    const at = anchor.getBoundingClientRect();
    const left = at.left + at.width / 2 - bubble.offsetWidth / 2;
    bubble.style.left = `${Math.max(8, Math.min(left, innerWidth - bubble.offsetWidth - 8))}px`;
    bubble.style.top = `${at.bottom + 8}px`;
  };
  const anchorOf = (event: Event) => (event.target as Element).closest<HTMLElement>('[data-tip]');
  root.addEventListener('pointerover', (event) => {
    const anchor = anchorOf(event);
    if (event.pointerType === 'touch' || !anchor) return;
    clearTimeout(timer);
    timer = window.setTimeout(() => show(anchor), kDelayMs);
  });
  root.addEventListener('pointerout', hide);
  // A finger that stays asks for the name, and does nothing when it is lifted.
  let isNamed = false;
  root.addEventListener('pointerdown', (event) => {
    hide();
    isNamed = false;
    const anchor = anchorOf(event);
    if (event.pointerType !== 'touch' || !anchor) return;
    timer = window.setTimeout(() => {
      isNamed = true;
      show(anchor);
    }, kStayMs);
  });
  root.addEventListener(
    'click',
    (event) => {
      if (!isNamed) return;
      isNamed = false;
      hide();
      event.preventDefault();
      event.stopPropagation();
    },
    true,
  );
  root.addEventListener('contextmenu', (event) => event.preventDefault());
  root.addEventListener('focusin', (event) => {
    const anchor = anchorOf(event);
    if (anchor?.matches(':focus-visible')) show(anchor);
  });
  root.addEventListener('focusout', hide);
  window.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') hide();
  });
}
