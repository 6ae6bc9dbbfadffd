// A text field over a row of the canvas: a name is changed where it stands.
import { byId, make } from './dom.ts';
import { putOver, type Place } from './text_size.ts';

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
  putOver(input, at);
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
