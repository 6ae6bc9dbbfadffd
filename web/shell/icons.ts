// Icons of the page: Lucide's SVG, by the names that the command table uses.
import {
  ArrowRight, Box, Camera, Check, ChevronDown, ChevronLeft, ChevronRight, Circle, CircleAlert, CircleCheck, CircleDot, Cylinder, Download, Ellipsis,
  Eraser, Eye, EyeOff, Hand, House, Image, ImageOff, ImagePlus, Images, Keyboard, Layers, List, Maximize, Minus, Palette, Pen, Pencil, PencilLine, Plus,
  Redo2, RefreshCw, Ruler, Scan, Shapes, ShieldCheck, Slice, SlidersHorizontal, Spline, SquarePen, Trash2, Undo2, X, ZoomIn, ZoomOut,
  UnfoldHorizontal, LineSquiggle, Bone, Ban, Lock, RotateCcw, CirclePlus, CircleMinus, Rows4, Rows2, UnfoldVertical, FoldVertical,
  Link, Shell, Rotate3d, ScanSearch, Anchor, FlipHorizontal2, ArrowLeftRight, Move, Move3d, Crosshair, Signature, ImageDown,
  FlipVertical2, Square, MousePointer2, Waypoints, History, Bookmark, BookmarkPlus, Tornado,
  ChartSpline, ChartLine, MoveHorizontal, Flower, Diamond,
  Brush, Cloud, Lightbulb, Footprints, Highlighter, Puzzle, Lasso, SquareDashed,
  SquaresUnite, SquaresSubtract, SquaresIntersect, CupSoda, Unlink,
  Copy, EllipsisVertical, FilePlus, FolderOpen, LayoutGrid, Save, SaveAll, TriangleAlert,
  ArrowDownFromLine, ArrowDownToLine, ArrowUpFromLine, ChevronUp, Group, Magnet, ScanFace, SquareStack, Ungroup, PaintRoller,
} from 'lucide-static';

const kIcons: Record<string, string> = {
  'arrow-right': ArrowRight, box: Box, camera: Camera, check: Check, 'chevron-down': ChevronDown, 'chevron-left': ChevronLeft, 'chevron-right': ChevronRight,
  'circle-alert': CircleAlert, 'circle-check': CircleCheck, 'circle-dot': CircleDot, cylinder: Cylinder, download: Download,
  ellipsis: Ellipsis, eraser: Eraser, eye: Eye, 'eye-off': EyeOff, hand: Hand, house: House, image: Image, 'image-off': ImageOff,
  'image-plus': ImagePlus, images: Images, keyboard: Keyboard, layers: Layers, list: List, maximize: Maximize, minus: Minus, palette: Palette,
  pen: Pen, pencil: Pencil, 'pencil-line': PencilLine, plus: Plus, 'redo-2': Redo2, 'refresh-cw': RefreshCw, ruler: Ruler, scan: Scan,
  shapes: Shapes, 'shield-check': ShieldCheck, slice: Slice, 'sliders-horizontal': SlidersHorizontal, spline: Spline, 'square-pen': SquarePen,
  'trash-2': Trash2, 'undo-2': Undo2, x: X, 'zoom-in': ZoomIn, 'zoom-out': ZoomOut,
  'unfold-horizontal': UnfoldHorizontal, 'line-squiggle': LineSquiggle, bone: Bone, ban: Ban, lock: Lock, 'rotate-ccw': RotateCcw,
  'circle-plus': CirclePlus, 'circle-minus': CircleMinus, 'rows-4': Rows4, 'rows-2': Rows2, 'unfold-vertical': UnfoldVertical,
  'fold-vertical': FoldVertical, lightbulb: Lightbulb, link: Link, shell: Shell, 'rotate-3d': Rotate3d, 'scan-search': ScanSearch, anchor: Anchor,
  'flip-horizontal-2': FlipHorizontal2, 'arrow-left-right': ArrowLeftRight, move: Move, 'move-3d': Move3d, crosshair: Crosshair,
  signature: Signature, 'image-down': ImageDown,
  'flip-vertical-2': FlipVertical2, square: Square, 'mouse-pointer-2': MousePointer2,
  waypoints: Waypoints, history: History, bookmark: Bookmark,
  'bookmark-plus': BookmarkPlus, tornado: Tornado, 'chart-spline': ChartSpline, 'chart-line': ChartLine,
  'move-horizontal': MoveHorizontal, flower: Flower, diamond: Diamond,
  brush: Brush, cloud: Cloud, footprints: Footprints, puzzle: Puzzle, lasso: Lasso, 'square-dashed': SquareDashed, highlighter: Highlighter,
  'squares-unite': SquaresUnite, 'squares-subtract': SquaresSubtract, 'squares-intersect': SquaresIntersect, 'cup-soda': CupSoda, unlink: Unlink,
  copy: Copy, 'ellipsis-vertical': EllipsisVertical, 'file-plus': FilePlus, 'folder-open': FolderOpen, 'layout-grid': LayoutGrid, save: Save,
  'save-all': SaveAll, 'triangle-alert': TriangleAlert,
  'arrow-down-from-line': ArrowDownFromLine, 'arrow-down-to-line': ArrowDownToLine, 'arrow-up-from-line': ArrowUpFromLine, 'chevron-up': ChevronUp, group: Group, magnet: Magnet, 'scan-face': ScanFace,
  'square-stack': SquareStack, ungroup: Ungroup, 'paint-roller': PaintRoller,
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
