// A picture larger than the graphics draw at once, in tiles: parts that cover each of its pixels once, each
// drawn with a margin in which whatever begins outside of it and reaches into it has room.
import type { ScreenSize } from './base/view.ts';

/** In pixels of the whole picture; may reach beyond it. */
export interface Part extends ScreenSize {
    x: number;
    y: number;
}

export interface Tile {
    /** Holds what is drawn. */
    drawn: Part;
    /** Holds what of it is taken. */
    kept: Part;
}

/**
 * All are drawn equally large, at most `side` pixels a side; even offsets keep differences between
 * neighbouring pixels the same. A margin of more than a quarter of a tile is cut down to that: tiles that
 * were little but margin would be too many. REQUIRES: side >= 8
 */
export function tilesOf({ width, height }: ScreenSize, side: number, margin: number): Tile[] {
    const edge = 2 * Math.ceil(Math.floor(Math.min(margin, side / 4)) / 2);
    const columns = stretchesOf(width, side, edge);
    return stretchesOf(height, side, edge).flatMap((row) =>
        columns.map((column) => ({
            drawn: { x: column.drawn, y: row.drawn, width: column.drawnLength, height: row.drawnLength },
            kept: { x: column.kept, y: row.kept, width: column.keptLength, height: row.keptLength },
        })),
    );
}

interface Stretch {
    drawn: number;
    drawnLength: number;
    kept: number;
    keptLength: number;
}

/** Divides one side of the picture. */
function stretchesOf(length: number, side: number, edge: number): Stretch[] {
    if (length <= side) return [{ drawn: 0, drawnLength: length, kept: 0, keptLength: length }];
    const count = Math.ceil(length / (2 * Math.floor((side - 2 * edge) / 2)));
    const step = 2 * Math.ceil(length / count / 2);
    return Array.from({ length: Math.ceil(length / step) }, (_, i) => ({
        ...{ drawn: i * step - edge, drawnLength: step + 2 * edge },
        ...{ kept: i * step, keptLength: Math.min(step, length - i * step) },
    }));
}
