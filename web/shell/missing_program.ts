// What a person is told where the engine's second program is missing in the middle of a call (web/platform/second_program.js).
import { t } from './words/words.ts';

let isLeaving = false;

// Only a dialog keeps the page waiting within a call.
export const whereItIsMissing = {
  askForNetwork: () => alert(t('A part of SpineLoft is still missing. Check the connection, then press OK.')),
  loadAgain: () => {
    if (isLeaving) return;
    isLeaving = true;
    alert(t('This SpineLoft is no longer on its server. Press OK to load the page again.'));
    location.reload();
  },
};
