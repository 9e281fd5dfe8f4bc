import { ShaderMaterial } from 'three';
import { describe, expect, it } from 'vitest';
import type { MeshChange, TimedMeshChange } from '../../mesh/meshChange.ts';
import { flowNames, stretchName, SurfaceMesh } from './surfaceMesh.ts';

/** Everything from some vertex on, but for what does not always come. */
function change(vertices: number, from: number, more: Partial<MeshChange> = {}): TimedMeshChange {
    const room = vertices - from;
    return {
        ...{ time: 0, vertices, triangles: 1, fromVertex: from, fromNormal: from, fromSeed: from, fromIndex: 0, tFrom: 0 },
        ...{ scalars: [], parts: null, cut: null, units: null, unresolved: null },
        positions: new Float32Array(3 * room),
        normals: new Float32Array(3 * room),
        seeds: new Float32Array(2 * room),
        indices: Uint32Array.of(0, 1, 2),
        ...more,
    };
}

const ones = (count: number): Float32Array => new Float32Array(count).fill(1);
const scalar =
    (...names: string[]) =>
    (vertices: number, from: number): Partial<MeshChange> => ({
        scalars: names.map((name) => ({ name, fromVertex: from, values: ones(vertices - from) })),
    });

/** By what they are: how they come with a mesh, and whether it has them. */
const arrays: [
    what: string,
    come: (vertices: number, from: number) => Partial<MeshChange>,
    has: (mesh: SurfaceMesh) => boolean,
][] = [
    ['colours', scalar('q'), (mesh) => mesh.scalar === 'q' && mesh.vertex(0).scalar === 1],
    ['stretching', scalar(stretchName), (mesh) => mesh.hasStretch],
    ['velocity', scalar(...flowNames), (mesh) => mesh.hasFlow && mesh.vertex(0).flow !== null],
    ['lengths of units', (vertices) => ({ units: ones(2 * vertices) }), (mesh) => mesh.hasUnits],
    ['what a grid cannot resolve', (vertices) => ({ unresolved: ones(2 * vertices) }), (mesh) => mesh.hasUnresolved],
    [
        'cuts',
        (vertices) => ({ cut: { levels: new Uint8Array(vertices).fill(255), trimmedCells: 0 } }),
        (mesh) => levels(mesh).some((level) => level > 0),
    ],
];

function levels({ mesh, vertices }: SurfaceMesh): number[] {
    return [...((mesh.geometry.attributes['cut']?.array as Uint8Array | undefined) ?? [])].slice(0, vertices);
}

function meshWith(come: (typeof arrays)[number][1]): SurfaceMesh {
    const mesh = new SurfaceMesh(new ShaderMaterial());
    mesh.wantedScalar = 'q';
    mesh.update(change(30, 0, come(30, 0)));
    return mesh;
}

describe.each(arrays)('%s of a surface', (what, come, has) => {
    it.each([
        ['another of as many vertices', 30, 0],
        ['a smaller one', 20, 0],
        ['a larger one', 40, 0],
        ['one whose last vertices have moved', 30, 25],
        ['one whose last vertices are others, and fewer', 28, 25],
    ])('go with the mesh that they came with, when %s comes without them', (_, vertices, from) => {
        const mesh = meshWith(come);
        expect(has(mesh)).toBe(true);
        mesh.update(change(vertices, from));
        if (what !== 'cuts') expect(has(mesh)).toBe(false);
        else expect(levels(mesh).slice(from)).toEqual(new Array(vertices - from).fill(0));
        mesh.update(change(vertices, 0, come(vertices, 0)));
        expect(has(mesh)).toBe(true);
    });

    it('stay, and grow with the mesh, where they come with what is new', () => {
        const mesh = meshWith(come);
        mesh.update(change(30, 30));
        expect(has(mesh)).toBe(true);
        mesh.update(change(40, 30, come(40, 30)));
        expect(has(mesh)).toBe(true);
    });
});

it('a surface that has shrunk and grown again without cuts has none of those of before', () => {
    const mesh = meshWith(arrays.at(-1)![1]);
    const nothingCut = { cut: { levels: new Uint8Array(0), trimmedCells: 0 } };
    mesh.update(change(20, 20, nothingCut));
    mesh.update(change(30, 20));
    expect(levels(mesh)).toEqual(new Array(30).fill(0));
});
