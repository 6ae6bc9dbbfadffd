// A text field over a row of the canvas: a name is changed where it stands.
import { byId, make } from './dom.ts';

/** Left, top, width and height, CSS pixels of the canvas. */
export type Place = [x: number, y: number, width: number, height: number];

/** Asks for a line of text in place; null when it was left by Escape or without a change. */
export function askInPlace(at: Place, text: string, value: string): Promise<string | null> {
  const input = make('input', {
    type: 'text',
    class: 'in-place',
    value,
    'aria-label': text,
    autocomplete: 'off',
    maxlength: '200',
  });
  const [x, y, width, height] = at;
  Object.assign(input.style, { left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px` });
  const canvas = byId('canvas');
  byId('stage').append(input);
  input.focus({ preventScroll: true });
  input.select();
  return new Promise((resolve) => {
    let isOver = false;
    const end = (answer: string | null, goesBack: boolean) => {
      if (isOver) return;
      isOver = true; // taking it out of the page blurs it
      watch.disconnect();
      input.remove();
      if (goesBack) canvas.focus({ preventScroll: true });
      resolve(answer === null || answer.trim() === '' || answer === value ? null : answer);
    };
    // What it lay over is elsewhere in a window of another size.
    const size = canvas.clientWidth + canvas.clientHeight;
    const watch = new ResizeObserver(() => {
      if (canvas.clientWidth + canvas.clientHeight !== size) end(input.value, false);
    });
    watch.observe(canvas);
    input.addEventListener('keydown', (event) => {
      if (event.isComposing) return;
      if (event.key === 'Enter') end(input.value, true);
      else if (event.key === 'Escape') end(null, true);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    input.addEventListener('blur', () => end(input.value, false));
  });
}
