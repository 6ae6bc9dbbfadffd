// Whether a person works with keys or with a pointer just now: the canvas shows its focus ring only for keys. The browser's own
// guess (:focus-visible) shows it also after a picture was dropped or opened by a program, and keeps it while a pen draws.

/** Keeps `data-input` of the page's root at "pointer" or "keys". */
export function watchInputKind(root: HTMLElement): void {
  root.dataset.input = 'pointer';
  window.addEventListener(
    'pointerdown',
    () => {
      root.dataset.input = 'pointer';
    },
    { capture: true },
  );
  window.addEventListener(
    'keydown',
    (event) => {
      if (!['Control', 'Shift', 'Alt', 'Meta'].includes(event.key)) root.dataset.input = 'keys';
    },
    { capture: true },
  );
}
