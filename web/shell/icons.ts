// Icons of the page: Lucide's SVG, by the names that the command table uses.
import {
  ArrowLeftToLine, Axis3d, Box, Camera, Circle, CircleAlert, CircleCheck, CircleHelp, ChevronDown, Download, Ellipsis,
  Eye, EyeOff, Focus, FolderOpen, Hand, Hexagon, House, Image, ImageMinus, ImageOff, ImagePlus, Images, Keyboard, Layers, ListTree, Maximize,
  Minus, Move, Move3d, MousePointer2, Orbit, Paintbrush, Palette, Pencil, PencilLine, PenLine, PenTool, Pin, Plus, PlusCircle, Redo, Redo2, Rotate3d, RotateCcw,
  Ruler, RulerDimensionLine, Save, Scan, Settings, Shapes, ShieldCheck, SkipForward, Slice, Sliders, SlidersHorizontal, Spline, Square, SquarePlus, Trash, Trash2, TextCursorInput, Type, Undo, Undo2, Upload,
  View, X, ZoomIn, ZoomOut,
} from 'lucide-static';

const kIcons: Record<string, string> = {
  'arrow-left-to-line': ArrowLeftToLine, 'axis-3d': Axis3d, box: Box, camera: Camera, circle: Circle,
  'circle-alert': CircleAlert, 'circle-check': CircleCheck, 'circle-help': CircleHelp, 'chevron-down': ChevronDown,
  download: Download, ellipsis: Ellipsis, eye: Eye, 'eye-off': EyeOff, focus: Focus, 'folder-open': FolderOpen,
  hand: Hand, hexagon: Hexagon, house: House, home: House, image: Image, 'image-minus': ImageMinus, 'image-off': ImageOff, 'image-plus': ImagePlus,
  images: Images, keyboard: Keyboard, layers: Layers, 'list-tree': ListTree, maximize: Maximize, minus: Minus, move: Move,
  'move-3d': Move3d, 'mouse-pointer-2': MousePointer2, orbit: Orbit, paintbrush: Paintbrush, palette: Palette,
  pencil: Pencil, 'pencil-line': PencilLine, 'pen-line': PenLine, 'pen-tool': PenTool, pin: Pin, plus: Plus, 'plus-circle': PlusCircle,
  'circle-plus': PlusCircle, redo: Redo, 'redo-2': Redo2, 'rotate-3d': Rotate3d, 'rotate-ccw': RotateCcw, ruler: Ruler,
  'ruler-dimension-line': RulerDimensionLine, save: Save, scan: Scan, settings: Settings, shapes: Shapes, 'shield-check': ShieldCheck, 'skip-forward': SkipForward,
  slice: Slice, sliders: Sliders, 'sliders-horizontal': SlidersHorizontal, spline: Spline, square: Square,
  'square-plus': SquarePlus, trash: Trash, 'trash-2': Trash2, 'text-cursor-input': TextCursorInput, type: Type, undo: Undo, 'undo-2': Undo2, upload: Upload, view: View,
  x: X, 'zoom-in': ZoomIn, 'zoom-out': ZoomOut,
};

/** Whether the page has a picture for this name. */
export function hasIcon(name: string): boolean {
  return name in kIcons;
}

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
