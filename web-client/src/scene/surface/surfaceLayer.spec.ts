import { describe, expect, it } from 'vitest';
import type { MeshChange } from './surfaceMesh.ts';
import { SurfaceLayer } from './surfaceLayer.ts';
import { plainStyle } from './surfaceStyle.ts';

/** A strip of so many vertices, t from 0 to 1. */
function meshOf(vertices: number): MeshChange {
    const t = Array.from({ length: vertices }, (_, i) => i / Math.max(1, vertices - 1));
    return {
        ...{ time: 0, vertices, triangles: 0, fromVertex: 0, fromNormal: 0, fromSeed: 0, fromIndex: 0, parts: null },
        positions: new Float32Array(3 * vertices),
        normals: new Float32Array(3 * vertices),
        seeds: new Float32Array(t.flatMap((each) => [0.5, each])),
        scalars: [{ name: 'speed', fromVertex: 0, values: new Float32Array(vertices) }],
        indices: new Uint32Array(0),
    };
}

describe('SurfaceLayer', () => {
    it('paints a surface that was empty at first as soon as there is something of it', () => {
        const layer = new SurfaceLayer();
        const hit = { surface: 's1', point: [0, 0, 0] as [number, number, number], s: 0.5, t: 0.5, scalar: 0, distance: 1 };
        const print = { size: 1, hits: [hit], radiusPx: 1 };
        layer.setStyle('s1', { ...plainStyle, painting: true });
        layer.set('s1', meshOf(0));
        layer.revealAll('s1', true);
        layer.paint(print, true);
        expect(layer.all[0]?.mask).toBeNull();
        layer.set('s1', meshOf(3));
        layer.paint(print, true);
        const mask = layer.all[0]?.mask;
        expect(mask?.isRevealed(0.5, 0.5)).toBe(true);
        expect([mask?.tStart, mask?.tLength]).toEqual([0, 1]);
    });
});
