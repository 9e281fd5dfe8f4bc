// Which of a rake's handles the panel lists, and what they are called.
import type { Handle } from '../../scene/rake/rakeHandles.ts';
import type { RakeShape } from '../../scene/rake/rakeShape.ts';

export interface HandleRow {
    handle: Handle;
    name: string;
}

/** With more points than these only the first, the last and one chosen by its number are listed. */
const mostRows = 12;

export function handleNameOf(handle: Handle, { kind, points }: RakeShape): string {
    if (handle === 'rotate') return 'Turn';
    if (kind === 'circle') return ['Centre', 'Rim', 'Tilt'][handle === 'middle' ? 0 : handle] ?? '';
    if (handle === 'middle') return 'Middle';
    if (handle === 0) return 'Start';
    return handle === points.length - 1 ? 'End' : `Point ${handle + 1}`;
}

/** @param shown the index of the point that is listed of many */
export function handleRows(shape: RakeShape, shown: number): HandleRow[] {
    const last = shape.points.length - 1;
    const all = [...shape.points.keys()];
    const few = last < mostRows ? all : [0, Math.min(shown, last - 1), last];
    const handles: Handle[] = shape.kind === 'circle' ? ['middle', 1, 2] : [...few, 'middle'];
    return handles.map((handle) => ({ handle, name: handleNameOf(handle, shape) }));
}
