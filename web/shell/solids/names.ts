// Names of what operands make together: equal names, equal solids.
import type { PartOperand, SolidNode, SolidOperand } from './protocol.ts';

interface Named {
  key: string;
}

export const isPart = (operand: SolidOperand): operand is PartOperand => 'mesh' in operand;

export const partKey = ({ mesh, part }: PartOperand) => `${mesh}#${part}`;

/** The key of a node's solid, or of the coarser one of a preview. */
export const nodeKey = (key: string, coarse: boolean) => (coarse ? `${key}~` : key);

/** In any order, and however often the same. */
export const keysOf = (of: Named[]) => [...new Set(of.map(({ key }) => key))].sort();

export const joinKey = (of: Named[]) => `join: ${keysOf(of).join(' ')}`;

/** Names what the operands make that do not change. What the first one of a cut loses is their union. */
export function restKey(kind: SolidNode['kind'], others: Named[], changed: boolean[]): string {
  return kind === 'join' || (kind === 'cut' && changed[0])
    ? joinKey(others)
    : `${kind}: ${others.map((each) => each.key).join(' ')}`;
}

/** Whether it pays to keep what the operands make that do not change; two or more of them. */
export function isWorthKeeping(kind: SolidNode['kind'], changed: boolean[]): boolean {
  const count = changed.filter(Boolean).length;
  return kind !== 'hollow' && count > 0 && changed.length - count >= 2;
}

/** Names what rounds the seam of two operands. */
export function seamKey({ kind, blend, coarse }: SolidNode, one: Named, other: Named): string {
  return `seam ${kind} ${blend}${coarse ? '~' : ''}: ${one.key} | ${other.key}`;
}

/** Whose seams are rounded: of a join any two, of a cut the first one and any other. */
export function pairsOf<Each>(kind: SolidNode['kind'], all: Each[]): [Each, Each][] {
  return all
    .slice(0, kind === 'cut' ? 1 : all.length)
    .flatMap((one, i) => all.slice(i + 1).map((other) => [one, other] as [Each, Each]));
}

/** Its seams are rounded. */
export function isRound({ kind, blend }: SolidNode): boolean {
  return blend > 0 && (kind === 'join' || kind === 'cut');
}
