import { BufferAttribute, BufferGeometry, Mesh, PerspectiveCamera, ShaderMaterial } from 'three';
import { expect, it } from 'vitest';
import { weighedValues } from './weighedValues.ts';

/** A square of side 2 about the origin, cut into two triangles; its values are its corners' numbers. */
function square(): Parameters<typeof weighedValues>[0] {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0), 3));
    geometry.setAttribute('scalar', new BufferAttribute(Float32Array.of(0, 1, 2, Number.NaN), 1));
    geometry.setAttribute('seed', new BufferAttribute(Float32Array.of(0, 1, 1, 1, 1, 2, 0, 2), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setDrawRange(0, 6);
    return { mesh: new Mesh(geometry, new ShaderMaterial()), vertices: 4, time: 5, tFrom: 1 };
}

it('each value stands for a third of the area round its vertex, and what is no number is left out', () => {
    const { values, weights } = weighedValues(square(), { source: 'scalar', tIsRelease: false }, null);
    expect(values).toEqual([0, 1, 2]);
    [4 / 3, 2 / 3, 4 / 3].forEach((weight, i) => expect(weights[i]).toBeCloseTo(weight));
    expect(weighedValues(square(), { source: 'age', tIsRelease: true }, null).values).toEqual([3, 3, 2, 2]);
});

it('what is beside the picture is not seen', () => {
    const camera = new PerspectiveCamera(40, 1, 0.1, 10);
    camera.position.set(1, 0, 2);
    camera.updateMatrixWorld();
    expect(weighedValues(square(), { source: 's', tIsRelease: false }, camera).values).toEqual([]);
    camera.position.set(1, 1, 2);
    camera.updateMatrixWorld();
    expect(weighedValues(square(), { source: 'scalar', tIsRelease: false }, camera).values).toEqual([2]);
});
