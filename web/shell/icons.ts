// Icons of the page: Lucide's SVG, by the names that the command table uses.
import {
  ArrowRight, Box, Camera, Check, ChevronDown, ChevronLeft, ChevronRight, Circle, CircleAlert, CircleCheck, CircleDot, Cylinder, Download, Ellipsis,
  Eraser, Eye, EyeOff, Hand, House, Image, ImageOff, ImagePlus, Images, Keyboard, Layers, List, Maximize, Minus, Palette, Pen, Pencil, PencilLine, Plus,
  Redo2, RefreshCw, Ruler, Scan, Shapes, ShieldCheck, Slice, SlidersHorizontal, Spline, SquarePen, Trash2, Undo2, X, ZoomIn, ZoomOut,
} from 'lucide-static';

const kIcons: Record<string, string> = {
  'arrow-right': ArrowRight, box: Box, camera: Camera, check: Check, 'chevron-down': ChevronDown, 'chevron-left': ChevronLeft, 'chevron-right': ChevronRight,
  'circle-alert': CircleAlert, 'circle-check': CircleCheck, 'circle-dot': CircleDot, cylinder: Cylinder, download: Download,
  ellipsis: Ellipsis, eraser: Eraser, eye: Eye, 'eye-off': EyeOff, hand: Hand, house: House, image: Image, 'image-off': ImageOff,
  'image-plus': ImagePlus, images: Images, keyboard: Keyboard, layers: Layers, list: List, maximize: Maximize, minus: Minus, palette: Palette,
  pen: Pen, pencil: Pencil, 'pencil-line': PencilLine, plus: Plus, 'redo-2': Redo2, 'refresh-cw': RefreshCw, ruler: Ruler, scan: Scan,
  shapes: Shapes, 'shield-check': ShieldCheck, slice: Slice, 'sliders-horizontal': SlidersHorizontal, spline: Spline, 'square-pen': SquarePen,
  'trash-2': Trash2, 'undo-2': Undo2, x: X, 'zoom-in': ZoomIn, 'zoom-out': ZoomOut,
};

/** A new decorative icon; a name the page does not know becomes a plain circle. */
export function icon(name: string): SVGElement {
  const holder = document.createElement('template');
  holder.innerHTML = (kIcons[name] ?? Circle).trim();
  const svg = holder.content.querySelector('svg') as SVGElement;
  svg.removeAttribute('width');
  svg.removeAttribute('height');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  return svg;
}
