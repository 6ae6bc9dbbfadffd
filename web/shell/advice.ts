// The one line of advice over the picture while there is no part yet.
import type { ShellView } from './shell_view.ts';

/** What to do next with the tool in hand; '' where nothing need be said, or the tool's bar and view say it. */
export function adviceFor({ picture, parts, tool, penMenu }: ShellView): string {
  if (!picture || parts > 0 || penMenu) return ''; // a menu needs the room
  const hasPen = tool === 'pen' || tool === 'eraser';
  if (!hasPen && tool !== 'draw') return '';
  if (picture.sketch && picture.strokes === 0) return 'Draw the outline of a thing';
  if (hasPen) return picture.finished ? 'Take Line and draw through its middle' : '';
  if (picture.sketch && picture.finished) return ''; // line, puff and flat are offered beside the drawing
  return 'Draw a line through the middle of the thing';
}
