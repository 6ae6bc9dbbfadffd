// Dialogs in the DOM: text entry needs the soft keyboard and input methods, which a canvas lacks.
import { make } from './dom.ts';
import { icon } from './icons.ts';

export function openDialog(title: string, body: Node[], className: string): HTMLDialogElement {
  const heading = make('h2', { id: 'dialog-title' }, title);
  const close = make('button', { type: 'button', class: 'dialog-close', 'aria-label': 'Close' });
  close.append(icon('x'));
  const dialog = make(
    'dialog',
    { class: className, 'aria-labelledby': 'dialog-title' },
    make('header', {}, heading, close),
    ...body,
  );
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close(); // on the backdrop
  });
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

/** Asks for a line of text, for a command; null when it was closed without an answer. */
export function askText(title: string, text: string, value = '', command?: string): Promise<string | null> {
  const input = make('input', { type: 'text', id: 'dialog-input', value, autocomplete: 'off', maxlength: '200' });
  const form = make(
    'form',
    { method: 'dialog' },
    make('label', { for: 'dialog-input' }, text),
    input,
    make(
      'div',
      { class: 'dialog-buttons' },
      make('button', { type: 'button', class: 'button', value: 'cancel' }, 'Cancel'),
      make('button', { type: 'submit', class: 'button button-primary', 'data-command': command }, 'OK'),
    ),
  );
  const dialog = openDialog(title, [form], 'dialog');
  input.select();
  return new Promise((resolve) => {
    let answer: string | null = null;
    form.addEventListener('submit', () => {
      answer = input.value;
    });
    form.querySelector('[value=cancel]')?.addEventListener('click', () => dialog.close());
    dialog.addEventListener('close', () => resolve(answer));
  });
}

/** Asks a question with buttons; the value of the one that was pressed, null when it was closed or `needless` fired. */
export function askChoice(
  title: string,
  text: string,
  choices: { value: string; label: string; command?: string }[],
  needless?: AbortSignal,
): Promise<string | null> {
  const buttons = choices.map(({ value, label, command }, i) => {
    const look = i === 0 ? 'button button-primary' : 'button';
    return make('button', { type: 'button', class: look, value, 'data-command': command }, label);
  });
  const dialog = openDialog(
    title,
    [make('p', {}, text), make('div', { class: 'dialog-buttons' }, ...buttons.reverse())],
    'dialog',
  );
  needless?.addEventListener('abort', () => dialog.close());
  return new Promise((resolve) => {
    let answer: string | null = null;
    for (const button of buttons) {
      button.addEventListener('click', () => {
        answer = button.value;
        dialog.close();
      });
    }
    dialog.addEventListener('close', () => resolve(answer));
  });
}
