import { describe, expect, it } from 'vitest';
import { revealedAt } from '../../testing/revealedAt.ts';
import { maskSize } from './surfaceMask.ts';
import type { TimedMeshChange } from '../../mesh/meshChange.ts';
import { SurfaceLayer } from './surfaceLayer.ts';
import { plainStyle } from './surfaceStyle.ts';

/** A strip of so many vertices, t from 0 to 1. */
function meshOf(vertices: number): TimedMeshChange {
    const t = Array.from({ length: vertices }, (_, i) => i / Math.max(1, vertices - 1));
    return {
        ...{
            time: 0,
            vertices,
            triangles: 0,
            fromVertex: 0,
            fromNormal: 0,
            fromSeed: 0,
            fromIndex: 0,
            tFrom: 0,
            parts: null,
            cut: null,
            units: null,
            unresolved: null,
        },
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
        expect(revealedAt(mask!, 0.5, 0.5)).toBe(true);
        expect([mask?.tStart, mask?.tLength]).toEqual([0, 1]);
    });

    it('colours a surface by nothing but values that came with it, and says what it has none of', () => {
        const layer = new SurfaceLayer();
        const drawn = (): string[] => {
            const { style, lacks } = layer.spanOf('s1')!;
            return [style.source, style.scalar, lacks];
        };
        layer.set('s1', meshOf(3));
        expect(drawn()).toEqual(['scalar', 'speed', '']);
        layer.setStyle('s1', { ...plainStyle, scalar: 'q' });
        expect(drawn()).toEqual(['scalar', 'speed', '']);
        layer.set('s1', { ...meshOf(3), scalars: [{ name: 'q', fromVertex: 0, values: new Float32Array(3) }] });
        expect(drawn()).toEqual(['scalar', 'q', '']);
        layer.set('s1', { ...meshOf(3), scalars: [] });
        expect(drawn()).toEqual(['constant', '', 'q']);
        layer.setStyle('s1', { ...plainStyle, source: 'age' });
        expect(drawn()).toEqual(['age', 'speed', '']);
    });

    it('keeps release times apart that are seconds since long ago', () => {
        const layer = new SurfaceLayer();
        layer.set('s1', { ...meshOf(3), tFrom: 3.8e9 });
        expect(layer.vertexOf('s1', 1)?.t).toBe(3.8e9 + 0.5);
        layer.setStyle('s1', { ...plainStyle, painting: true });
        layer.revealAll('s1', true);
        const mask = layer.all[0]!.mask!;
        expect([mask.tStart, mask.tLength]).toEqual([3.8e9, 1]);
    });

    it('shows a painted surface that was deleted as it was when that is taken back, however intricate', () => {
        const layer = new SurfaceLayer();
        const comeBack = (): void => {
            layer.set('s1', meshOf(3));
            layer.setStyle('s1', { ...plainStyle, painting: true });
        };
        comeBack();
        layer.revealAll('s1', true);
        const before = layer.all[0]!.mask!.texels;
        before.forEach((_, i) => {
            // A patchwork whose patches are as large as texels of the coarsest code.
            const [row, column] = [Math.floor(i / maskSize / 8), Math.floor((i % maskSize) / 8)];
            before[i] = (row * row * 31 + column * column * 17 + row * column) % 7 < 3 ? 255 : 0;
        });
        const painted = before.slice();
        expect(layer.maskCode('s1')).toBeNull();
        layer.remove('s1');
        expect(layer.maskCode('s1')).toBeNull();
        comeBack();
        expect(layer.all[0]!.mask!.texels.every((texel, i) => texel === painted[i])).toBe(true);
    });

    it('knows nothing of masks any more when its surfaces are others', () => {
        const layer = new SurfaceLayer();
        for (const id of ['s1', 's2']) {
            layer.set(id, meshOf(3));
            layer.setStyle(id, { ...plainStyle, painting: true });
            layer.revealAll(id, true);
        }
        layer.remove('s2');
        layer.forgetMasks();
        expect(['s1', 's2'].map((id) => layer.maskCode(id))).toEqual([undefined, undefined]);
    });
});
