// The size of text that the browser asks for. The page is laid out in shares of it, and so is the canvas: its unit is one
// CSS pixel at the usual size.

/** CSS pixels of text at the usual size, as the style sheets count (.ci/lib/site.mjs). */
const kUsual = 16;

/** CSS pixels in one unit of the canvas. */
export function canvasUnit(): number {
  return parseFloat(getComputedStyle(document.documentElement).fontSize) / kUsual || 1;
}

/** A length of the canvas for a style. */
export const canvasLength = (units: number): string => `${units / kUsual}rem`;

/** Left, top, width and height, units of the canvas. */
export type Place = [x: number, y: number, width: number, height: number];

/** Puts an element over this place of the canvas. */
export function putOver(element: HTMLElement | SVGElement, [x, y, width, height]: Place): void {
  Object.assign(element.style, {
    left: canvasLength(x),
    top: canvasLength(y),
    width: canvasLength(width),
    height: canvasLength(height),
  });
}
