// Runs in a page: draws sheets of known shape and velocity with the scene's surfaces, to measure what looks cost and to look at
// their pixels. The GPU finishes each picture before it is measured.
import { Color, OrthographicCamera, Scene, WebGLRenderer } from 'three';
import { type BodyMesh, cutLevel, type TimedMeshChange } from '../../../web-client/src/mesh/meshChange.ts';
import { View } from '../../../web-client/src/scene/base/view.ts';
import { Lights } from '../../../web-client/src/scene/graphics.ts';
import { DrawnBody } from '../../../web-client/src/scene/surface/drawnBody.ts';
import type { FlowTexture } from '../../../web-client/src/scene/surface/surfaceMaterial.ts';
import { SurfaceLayer } from '../../../web-client/src/scene/surface/surfaceLayer.ts';
import { plainStyle, type SurfaceStyle } from '../../../web-client/src/scene/surface/surfaceStyle.ts';

/** A sheet over all of the picture: a picture's width is `size` long, its lower left corner lies at `corner`. */
export interface FlatFlow {
    corner: readonly [number, number, number];
    size: number;
    /** How far waves of it reach up. */
    waves: number;
    /** The velocity's size and direction (radians) at the left end and at the right end. */
    speed: readonly [number, number];
    angle: readonly [number, number];
    /** Of the camera, onto the middle of the sheet. */
    zoom?: number;
    /** Of all vertices, see worker/vertexQuantities.ts. */
    unresolved?: readonly [number, number];
    /** Vertices each way, instead of as many as nobody sees. */
    grid?: readonly [number, number];
    /** Cells between these parts of its width and its height are not there, and rows lean by so much. */
    hole?: readonly [u0: number, u1: number, v0: number, v1: number];
    lean?: number;
    /** It is cut along a wave. */
    cut?: true;
}

export interface LookBench {
    /** Makes a picture ready; returns how to draw it so often, each time to its end. */
    ready(flow: FlatFlow, look: Partial<SurfaceStyle>): (times: number) => void;
    /** The same of a body of that shape, with its texture or without. */
    readyBody(flow: FlatFlow, texture: FlowTexture): (times: number) => void;
    /** Brightness by pixels, rows from the bottom. */
    light(flow: FlatFlow, look: Partial<SurfaceStyle>, time: number): number[];
}

declare global {
    interface Window {
        lookBench?: LookBench;
    }
}

function sheet(flat: FlatFlow, time: number): TimedMeshChange {
    const { corner, size, waves, speed, angle, unresolved, hole, lean } = flat;
    const [columns, rows] = flat.grid ?? [200, 100];
    const count = columns * rows;
    const height = (size * innerHeight) / innerWidth;
    const [positions, normals, seeds] = [new Float32Array(3 * count), new Float32Array(3 * count), new Float32Array(2 * count)];
    const flow = [0, 1, 2].map(() => new Float32Array(count)) as [Float32Array, Float32Array, Float32Array];
    const mixed = ([a, b]: readonly [number, number], at: number): number => a + (b - a) * at;
    for (let i = 0; i < count; ++i) {
        const [u, v] = [(i % columns) / (columns - 1), Math.floor(i / columns) / (rows - 1)];
        const [dx, dy] = [waves * Math.cos(9 * u) * 9, -waves * Math.sin(7 * v) * 7];
        const up = size * waves * (Math.sin(9 * u) + Math.cos(7 * v));
        positions.set([corner[0] + size * (u + (lean ?? 0) * (v - 0.5)), corner[1] + height * v, corner[2] + up], 3 * i);
        const steep = Math.hypot(dx, (dy * size) / height, 1);
        normals.set([-dx / steep, (-dy * size) / height / steep, 1 / steep], 3 * i);
        seeds.set([u, v], 2 * i);
        const [along, turn] = [mixed(speed, u), mixed(angle, u)];
        flow[0][i] = along * Math.cos(turn);
        flow[1][i] = along * Math.sin(turn);
        flow[2][i] = along * (Math.cos(turn) * dx + (Math.sin(turn) * dy * size) / height);
    }
    const speeds = Float32Array.from({ length: count }, (_, i) => mixed(speed, (i % columns) / (columns - 1)));
    const quads = (columns - 1) * (rows - 1);
    const indices = new Uint32Array(6 * quads);
    for (let i = 0; i < quads; ++i) {
        const at = Math.floor(i / (columns - 1)) * columns + (i % (columns - 1));
        const [u, v] = [((at % columns) + 0.5) / (columns - 1), (Math.floor(at / columns) + 0.5) / (rows - 1)];
        if (hole !== undefined && u > hole[0] && u < hole[1] && v > hole[2] && v < hole[3]) continue;
        indices.set([at, at + 1, at + columns, at + 1, at + columns + 1, at + columns], 6 * i);
    }
    const scalars = ['velocity_x', 'velocity_y', 'velocity_z'].map((name, axis) => ({
        ...{ name, fromVertex: 0, values: flow[axis]! },
    }));
    scalars.push({ name: 'speed', fromVertex: 0, values: speeds });
    const lost = unresolved === undefined ? null : Float32Array.from({ length: 2 * count }, (_, i) => unresolved[i % 2]!);
    const levels = Uint8Array.from({ length: count }, (_, i) => {
        const [u, v] = [(i % columns) / (columns - 1), Math.floor(i / columns) / (rows - 1)];
        return Math.max(0, Math.min(255, cutLevel * (1 + 4 * (u - 0.6 + 0.1 * Math.sin(9 * v)))));
    });
    const cut = flat.cut === undefined ? null : { levels, trimmedCells: 0 };
    return {
        ...{ time, vertices: count, triangles: 2 * quads, fromVertex: 0, positions, fromNormal: 0, normals, fromSeed: 0, seeds },
        ...{ tFrom: 0, scalars, fromIndex: 0, indices, parts: null, cut, units: null, unresolved: lost },
    };
}

/** The same sheet as a body, and the flow along it. */
function bodyOf(flow: FlatFlow): { body: BodyMesh; flow: Float32Array } {
    const { positions, normals, indices, scalars } = sheet(flow, 0);
    const [x, y, z] = scalars.map(({ values }) => values);
    const along = Float32Array.from({ length: positions.length }, (_, i) => [x!, y!, z!][i % 3]![Math.floor(i / 3)]!);
    return { body: { positions, normals, indices }, flow: along };
}

class Picture {
    private readonly layer = new SurfaceLayer();
    private readonly scene = new Scene();
    private readonly camera = new OrthographicCamera();
    private readonly renderer = new WebGLRenderer({ preserveDrawingBuffer: true });

    constructor() {
        this.renderer.setSize(innerWidth, innerHeight);
        this.scene.background = new Color(0, 0, 0);
        this.layer.attach(this.scene);
    }

    show(flow: FlatFlow, look: Partial<SurfaceStyle>, time: number): void {
        this.place(flow);
        this.layer.setStyle('s', { ...plainStyle, source: 'constant', ...look });
        this.layer.set('s', sheet(flow, time));
    }

    showBody(flow: FlatFlow, texture: FlowTexture): void {
        this.place(flow);
        const [drawn, lights] = [new DrawnBody(this.layer, () => undefined), new Lights()];
        const { body, flow: along } = bodyOf(flow);
        drawn.set(body);
        drawn.setTime(texture === 'flowing' ? 0 : null);
        drawn.setValues({ flow: along, field: null }, texture !== 'none');
        this.scene.add(drawn.object, lights.object);
        const size = { width: innerWidth, height: innerHeight };
        lights.update(new View(this.camera, size, size, 1));
    }

    private place({ size, corner: [x, y, z], zoom }: FlatFlow): void {
        const height = (size * innerHeight) / innerWidth;
        this.layer.setBounds([x, x + size, y, y + height, z - size, z + size]);
        const { camera } = this;
        [camera.left, camera.right, camera.bottom, camera.top] = [-size / 2, size / 2, -height / 2, height / 2];
        [camera.near, camera.far, camera.zoom] = [0, 4 * size, zoom ?? 1];
        camera.updateProjectionMatrix();
        camera.position.set(x + size / 2, y + height / 2, z + 2 * size);
        camera.updateMatrixWorld();
    }

    draw(width: number, height: number): Uint8Array {
        this.renderer.render(this.scene, this.camera);
        const gl = this.renderer.getContext();
        const pixels = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return pixels;
    }
}

let kept: Picture | null = null;

window.lookBench = {
    ready: (flow, look) => {
        const picture = new Picture();
        picture.show(flow, look, 0);
        return (times) => {
            for (let i = 0; i < times; ++i) picture.draw(1, 1);
        };
    },
    readyBody: (flow, texture) => {
        const picture = new Picture();
        picture.showBody(flow, texture);
        return (times) => {
            for (let i = 0; i < times; ++i) picture.draw(1, 1);
        };
    },
    light: (flow, look, time) => {
        kept ??= new Picture();
        kept.show(flow, look, time);
        const pixels = kept.draw(innerWidth, innerHeight);
        return Array.from(
            { length: innerWidth * innerHeight },
            (_, i) => pixels[4 * i]! + pixels[4 * i + 1]! + pixels[4 * i + 2]!,
        );
    },
};
