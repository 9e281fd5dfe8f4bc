// The picture: domain outline, obstacle, surfaces and rake, drawn on demand. Knows nothing of the
// server; session/ feeds it and listens to it.
import {
    Color,
    DirectionalLight,
    HemisphereLight,
    type Mesh,
    Scene,
    type Vector2,
    WebGLRenderer,
} from 'three';
import type { Vec3 } from '../protocol/messages.ts';
import { CameraControls } from './cameraControls.ts';
import type { Bounds } from './domainAxes.ts';
import { DomainOutline } from './domainOutline.ts';
import { FrameLoop } from './frameLoop.ts';
import type { Graphics } from './graphics.ts';
import { whenDrawn } from './gpuFence.ts';
import { createObstacleMesh } from './obstacleMesh.ts';
import { projectToScreen, type ScreenPoint, type ScreenSize } from './rakeDrag.ts';
import { RakeInteraction, type RakeMove } from './rakeInteraction.ts';
import { RakeWidget } from './rakeWidget.ts';
import { createSurfaceMaterial } from './surfaceMaterial.ts';
import { type MeshChange, SurfaceMesh } from './surfaceMesh.ts';

const background = 0x0b1018;
const movingPixelRatio = 0.5;

export interface FlowSceneOptions {
    canvas: HTMLCanvasElement;
    /** Lies over the canvas and takes the text of the axes. */
    labels: HTMLElement;
    graphics: Graphics;
    onRakeMove: (move: RakeMove) => void;
}

export class FlowScene {
    readonly loop = new FrameLoop((finished) => this.drawFrame(finished));
    readonly controls = new CameraControls(this.loop.request, (held) => this.hold(held));
    readonly rake = new RakeWidget();
    readonly interaction: RakeInteraction;
    readonly renderer: WebGLRenderer;
    framesDrawn = 0;
    private readonly canvas: HTMLCanvasElement;
    private readonly labels: HTMLElement;
    private readonly software: boolean;
    private readonly scene = new Scene();
    private readonly surfaceMaterial = createSurfaceMaterial();
    private readonly surfaces = new Map<string, SurfaceMesh>();
    private readonly afterNextFrame: ((time: number) => void)[] = [];
    private outline: DomainOutline | null = null;
    private obstacle: Mesh | null = null;

    constructor(options: FlowSceneOptions) {
        this.canvas = options.canvas;
        this.labels = options.labels;
        this.software = options.graphics.software;
        this.renderer = createRenderer(options);
        // Before the camera controls, which must not see a press on a handle.
        this.interaction = new RakeInteraction({
            canvas: this.canvas,
            widget: this.rake,
            camera: this.controls.camera,
            requestFrame: this.loop.request,
            onMove: options.onRakeMove,
            onHold: (held) => this.hold(held),
        });
        this.controls.connect(this.canvas);
        this.scene.background = new Color(background);
        this.scene.add(this.rake.group, this.controls.camera);
        this.addLights();
        new ResizeObserver(() => this.resize()).observe(this.canvas);
        this.canvas.addEventListener('webglcontextrestored', this.loop.request);
    }

    get size(): ScreenSize {
        return { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    }

    /** Canvas position of a point, in CSS pixels; null behind the camera. */
    project(point: Vec3): ScreenPoint | null {
        this.controls.camera.updateMatrixWorld();
        return projectToScreen(point, this.controls.camera, this.size);
    }

    setDomain(bounds: Bounds): void {
        if (this.outline !== null) {
            this.scene.remove(this.outline.lines);
            this.outline.dispose();
        }
        this.outline = new DomainOutline(bounds, this.labels);
        this.scene.add(this.outline.lines);
        this.controls.setBounds(bounds);
        this.loop.request();
    }

    setObstacle(positions: Float32Array, indices: Uint32Array): void {
        if (this.obstacle !== null) {
            this.scene.remove(this.obstacle);
            this.obstacle.geometry.dispose();
        }
        this.obstacle = createObstacleMesh(positions, indices);
        this.scene.add(this.obstacle);
        this.loop.request();
    }

    setRange(range: readonly [number, number]): void {
        (this.surfaceMaterial.uniforms['range']?.value as Vector2).set(...range);
        this.loop.request();
    }

    /** Shows what is new in a surface. */
    setSurface(id: string, change: MeshChange): void {
        let surface = this.surfaces.get(id);
        if (surface === undefined) {
            surface = new SurfaceMesh(this.surfaceMaterial);
            this.surfaces.set(id, surface);
            this.scene.add(surface.mesh);
        }
        surface.update(change);
        this.loop.request();
    }

    /** `shown` is told when the next frame is on the screen as far as a page can know. */
    whenDrawn(shown: (time: number) => void): void {
        this.afterNextFrame.push(shown);
        this.loop.request();
    }

    /** A vertex of a surface and its scalar, as they are drawn. */
    vertexOf(id: string, vertex: number): { point: Vec3; scalar: number } | null {
        return this.surfaces.get(id)?.vertex(vertex) ?? null;
    }

    removeSurface(id: string): void {
        const surface = this.surfaces.get(id);
        if (surface === undefined) return;
        this.surfaces.delete(id);
        this.scene.remove(surface.mesh);
        surface.dispose();
        this.loop.request();
    }

    /** Draws at once and returns the picture's pixels, RGBA from the bottom left. */
    readPixels(): { width: number; height: number; pixels: Uint8Array } {
        this.draw();
        const gl = this.renderer.getContext() as WebGL2RenderingContext;
        const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
        const pixels = new Uint8Array(width * height * 4);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return { width, height, pixels };
    }

    private draw(): void {
        const { camera } = this.controls;
        const { size } = this;
        if (size.width === 0 || size.height === 0) return;
        this.controls.camera.updateMatrixWorld();
        this.rake.update(camera, size);
        this.outline?.update(camera.position.toArray() as Vec3, (p) =>
            projectToScreen(p, camera, size),
        );
        this.renderer.render(this.scene, camera);
        this.framesDrawn += 1;
    }

    private drawFrame(finished: () => void): void {
        this.draw();
        const listeners = this.afterNextFrame.splice(0);
        whenDrawn(this.renderer.getContext() as WebGL2RenderingContext, (time) => {
            finished();
            if (time !== null) for (const listener of listeners) listener(time);
        });
    }

    /** While something is moved, software rendering saves pixels: a late picture is worse than a soft one. */
    private hold(held: boolean): void {
        if (!this.software) return;
        this.renderer.setPixelRatio(held ? movingPixelRatio : 1);
        this.loop.request();
    }

    private addLights(): void {
        const key = new DirectionalLight(0xffffff, 3);
        // Fixed to the camera, like the light of the surfaces.
        key.position.set(0.4, 0.6, 1);
        this.controls.camera.add(key, key.target);
        const sky = new HemisphereLight(0xdfe8ff, 0x5a6474, 1.1);
        sky.position.set(0, 0, 1);
        this.scene.add(sky);
    }

    private resize(): void {
        const { width, height } = this.size;
        if (width === 0 || height === 0) return;
        this.renderer.setSize(width, height, false);
        this.controls.setAspect(width / height);
        // At once: the canvas is blank after a change of size.
        this.draw();
    }
}

function createRenderer({ canvas, graphics }: FlowSceneOptions): WebGLRenderer {
    const renderer = new WebGLRenderer({
        canvas,
        antialias: !graphics.software,
        powerPreference: 'high-performance',
    });
    renderer.setPixelRatio(graphics.software ? 1 : Math.min(2, devicePixelRatio));
    return renderer;
}
