// Finds what is under the pointer: the surfaces and the body are drawn once more, only the few pixels round
// it, with places and numbers instead of colours into float32 targets, and read back. Sees what the user
// sees: cut, hidden and painted alike.
import {
    type BufferGeometry,
    type Camera,
    Color,
    DoubleSide,
    FloatType,
    GLSL3,
    Mesh,
    NearestFilter,
    NoBlending,
    Scene,
    ShaderMaterial,
    type WebGLRenderer,
    WebGLRenderTarget,
} from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { isOrthographic, type ScreenPoint, type View } from '../base/view.ts';
import { pushBackGlsl } from './renderPasses.ts';
import type { PickGrid, PickHit, PickOptions } from './pickHit.ts';
import type { SurfaceLayer } from './surfaceLayer.ts';
import { mostClipPlanes } from './surfaceShader.ts';

const bodyId = 1;
const firstSurfaceId = 2;

export class SurfacePick {
    private readonly renderer: WebGLRenderer;
    private readonly layer: SurfaceLayer;
    private readonly scene = new Scene();
    private readonly bodyMaterial: ShaderMaterial;
    private target: WebGLRenderTarget | null = null;

    constructor(renderer: WebGLRenderer, layer: SurfaceLayer) {
        this.renderer = renderer;
        this.layer = layer;
        this.bodyMaterial = new ShaderMaterial({
            glslVersion: GLSL3,
            vertexShader: bodyVertexShader,
            fragmentShader: bodyFragmentShader,
            uniforms: { clip: layer.bodyClip, push: layer.bodyPush },
            side: DoubleSide,
            blending: NoBlending,
        });
    }

    /** Returns what is exactly there. */
    at(view: View, bodies: readonly BufferGeometry[], at: ScreenPoint, options: PickOptions = {}): PickHit | null {
        return this.grid(view, bodies, at, 0, options).hits[0] ?? null;
    }

    grid(view: View, bodies: readonly BufferGeometry[], at: ScreenPoint, radius: number, options: PickOptions = {}): PickGrid {
        const size = 2 * radius + 1;
        const corner = { x: at.x - radius, y: at.y - radius };
        const surfaces = this.fillScene(bodies);
        this.layer.shared.respectPaint.value = options.throughPaint !== true;
        const target = this.targetOf(size);
        this.draw(windowOf(view, corner, size), target);
        this.layer.shared.respectPaint.value = true;
        this.scene.clear();
        const [places, numbers] = [0, 1].map((texture) => {
            const pixels = new Float32Array(4 * size * size);
            this.renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels, undefined, texture);
            return pixels;
        }) as [Float32Array, Float32Array];
        const hits: (PickHit | null)[] = [];
        for (let row = size - 1; row >= 0; --row) {
            for (let column = 0; column < size; ++column) {
                const pixel = 4 * (row * size + column);
                hits.push(hitOf(places.subarray(pixel, pixel + 4), numbers.subarray(pixel, pixel + 4), surfaces, view));
            }
        }
        return { corner, size, hits };
    }

    dispose(): void {
        this.target?.dispose();
        this.bodyMaterial.dispose();
    }

    private fillScene(bodies: readonly BufferGeometry[]): PickedSurface[] {
        for (const body of bodies) this.scene.add(proxyOf(body, this.bodyMaterial));
        return this.layer.all.map(({ id, mesh, materials }, i) => {
            materials.pickId = firstSurfaceId + i;
            if (mesh.mesh.visible) this.scene.add(proxyOf(mesh.mesh.geometry, materials.pick));
            return { id, tFrom: mesh.tFrom };
        });
    }

    private draw(camera: Camera, target: WebGLRenderTarget): void {
        const { renderer } = this;
        const before = {
            target: renderer.getRenderTarget(),
            colour: renderer.getClearColor(new Color()),
            alpha: renderer.getClearAlpha(),
        };
        renderer.setRenderTarget(target);
        renderer.setClearColor(0, 0);
        renderer.render(this.scene, camera);
        renderer.setRenderTarget(before.target);
        renderer.setClearColor(before.colour, before.alpha);
    }

    private targetOf(size: number): WebGLRenderTarget {
        if (this.target?.width === size) return this.target;
        this.target?.dispose();
        const filter = { minFilter: NearestFilter, magFilter: NearestFilter };
        this.target = new WebGLRenderTarget(size, size, { count: 2, type: FloatType, ...filter });
        return this.target;
    }
}

function proxyOf(geometry: BufferGeometry, material: ShaderMaterial): Mesh {
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    return mesh;
}

/** The camera, but of the whole picture only a square; the centre of its first pixel is at `corner`. */
function windowOf({ camera, size: { width, height } }: View, corner: ScreenPoint, size: number): Camera {
    const window = camera.clone();
    window.setViewOffset(width, height, corner.x - 0.5, corner.y - 0.5, size, size);
    window.updateMatrixWorld();
    return window;
}

interface PickedSurface {
    id: string;
    tFrom: number;
}

function hitOf(place: Float32Array, numbers: Float32Array, surfaces: readonly PickedSurface[], view: View): PickHit | null {
    const id = Math.round(place[3]!);
    if (id < bodyId) return null;
    const point: Vec3 = [place[0]!, place[1]!, place[2]!];
    const [s, t, scalar, depth] = numbers as unknown as [number, number, number, number];
    const { eye } = view;
    const distance = isOrthographic(view.camera) ? depth : Math.hypot(...point.map((x, i) => x - eye[i]!));
    const surface = surfaces[id - firstSurfaceId];
    return { surface: surface?.id ?? null, point, s, t: (surface?.tFrom ?? 0) + t, scalar, distance };
}

const bodyVertexShader = `
out vec3 worldPosition;
out float depth;
${pushBackGlsl}
void main() {
    vec4 inWorld = modelMatrix * vec4(position, 1.0);
    worldPosition = inWorld.xyz;
    vec4 inView = viewMatrix * inWorld;
    depth = -inView.z;
    gl_Position = projectionMatrix * inView;
    pushBack(inView);
}`;

const bodyFragmentShader = `
in vec3 worldPosition;
in float depth;
uniform vec4 clip[${mostClipPlanes}];
layout(location = 0) out vec4 point;
layout(location = 1) out vec4 numbers;
void main() {
    for (int i = 0; i < ${mostClipPlanes}; ++i) if (dot(clip[i].xyz, worldPosition) > clip[i].w) discard;
    point = vec4(worldPosition, ${bodyId}.0);
    numbers = vec4(0.0, 0.0, 0.0, depth);
}`;
