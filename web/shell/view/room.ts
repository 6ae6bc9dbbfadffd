// The model in the room around the visitor: <model-viewer> does it, by WebXR or by Quick Look. Loaded when it is asked for.
import '@google/model-viewer';
import { make } from '../dom.ts';
import { icon } from '../icons.ts';
import { t } from '../words/words.ts';

/** What is used of the element; see its own documentation. */
interface ModelViewer extends HTMLElement {
  readonly canActivateAR: boolean;
  activateAR(): Promise<void>;
}

/** Opens the model over the page, with a button that puts it into the room; the press may not be long ago for that. */
export async function showInRoom(glb: Uint8Array<ArrayBuffer>, name: string): Promise<void> {
  const address = URL.createObjectURL(new Blob([glb], { type: 'model/gltf-binary' }));
  // Not by Scene Viewer, which would have the model fetched by another program.
  const viewer = make('model-viewer' as 'div', {
    class: 'view-ar',
    src: address,
    alt: name,
    ar: true,
    'ar-modes': 'webxr quick-look',
    'camera-controls': true,
    'interaction-prompt': 'none',
  }) as HTMLElement as ModelViewer;
  const words = make('p', { class: 'view-words' });
  const place = make('button', { type: 'button', class: 'button button-primary' }, 'Put it in the room');
  const back = make('button', { type: 'button', class: 'button' });
  back.append(icon('x'), ' ', make('span', {}, 'Close'));
  const frame = make('div', { class: 'view-ar', role: 'dialog', 'aria-label': 'In your room' }, viewer);
  frame.append(make('div', { class: 'view-ar-buttons' }, words, place, back));
  back.addEventListener('click', () => {
    frame.remove();
    URL.revokeObjectURL(address);
  });
  place.addEventListener('click', () => void viewer.activateAR());
  const loaded = new Promise((resolve) => {
    viewer.addEventListener('load', resolve, { once: true });
    viewer.addEventListener('error', resolve, { once: true });
  });
  document.querySelector('main')?.append(frame);
  back.focus();
  await loaded;
  place.hidden = !viewer.canActivateAR;
  if (place.hidden) words.textContent = t('This device cannot show things in the room around it.');
}
