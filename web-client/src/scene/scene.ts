// The picture: surfaces, rake, domain and body, drawn on demand. Knows nothing of the server; session/ feeds
// it and listens to it.
import { type Color, Scene, type WebGLRenderer } from 'three';
import type { TimedMeshChange } from '../mesh/meshChange.ts';
import type { Vec3 } from '../protocol/messages.ts';
import { CameraControls } from './camera/cameraControls.ts';
import { type Bounds, boundsRound } from './domain/domainAxes.ts';
import { DomainOutline } from './domain/domainOutline.ts';
import { ScaleBar } from './domain/scaleBar.ts';
import { FrameLoop, Movement, MovingResolution, restMs, Stillness, whenDrawn } from './frameLoop.ts';
import { createRenderer, type Graphics, Lights, pictureColours } from './graphics.ts';
import { PointerTools } from './base/pointerTools.ts';
import { RakeAim } from './rake/rakeAim.ts';
import { RakeInteraction } from './rake/rakeInteraction.ts';
import { RakeLayer } from './rake/rakeLayer.ts';
import { SampledPicture, samplePlaces } from './sampledPicture.ts';
import { pairs } from './surface/contactShade.ts';
import { DrawnBody } from './surface/drawnBody.ts';
import { SurfaceLayer } from './surface/surfaceLayer.ts';
import { noSurface, type PickGrid, type PickHit, type PickOptions } from './surface/pickHit.ts';
import { SurfacePick } from './surface/surfacePick.ts';
import { type Cover, coverOf } from './base/labels.ts';
import { type Layer, type Part, type ScreenPoint, type ScreenSize, View } from './base/view.ts';

/** The pixel ratio of software rendering, while nothing is known of its speed. */
const firstSoftwareRatio = 0.5;
const exactAfterMs = 300;
/** Where pictures are slow, so are the hands that wait for them: a sharp picture must not come between two of
 *  a movement. */
const picturesOfRest = 3;
const longestRestMs = 600;

export interface FlowSceneOptions {
    canvas: HTMLCanvasElement;
    /** Lies over the canvas and takes the text of the axes. */
    labels: HTMLElement;
    graphics: Graphics;
}

export class FlowScene {
    readonly loop = new FrameLoop((finished, changed) => this.drawFrame(finished, changed));
    readonly controls = new CameraControls({
        requestFrame: this.loop.request,
        onHold: (held) => this.hold(held),
        onTurn: () => this.movement.stir(performance.now()),
    });
    readonly surfaces = new SurfaceLayer();
    readonly body = new DrawnBody(this.surfaces, this.loop.request);
    readonly rakes: RakeLayer;
    readonly aim: RakeAim;
    readonly interaction: RakeInteraction;
    readonly pointerTools: PointerTools;
    readonly renderer: WebGLRenderer;
    /** Lies over the canvas. */
    readonly labels: HTMLElement;
    framesDrawn = 0;
    /** How the last picture shows what can be seen through. */
    transparency: 'none' | 'blended' | 'exact' = 'none';
    /** When the domain was on the screen first, on performance.now()'s clock. */
    firstPictureMs: number | null = null;
    private readonly canvas: HTMLCanvasElement;
    private readonly picker: SurfacePick;
    private readonly software: boolean;
    private readonly scene = new Scene();
    private readonly movement = new Movement();
    readonly movingResolution: MovingResolution;
    /** Pixels for one of CSS, of a picture that stands still. */
    private readonly fullRatio: number;
    private readonly rest = new Stillness(() => this.drawBetter('sharpNext'), restMs);
    private readonly stillness = new Stillness(() => this.drawBetter('exactNext'), exactAfterMs);
    /** Pictures that one which stands still, or is saved, is the mean of. */
    private readonly places: readonly (readonly [number, number])[];
    private readonly sampled: SampledPicture;
    private readonly smoothness = new Stillness(() => this.loop.requestBetter(), restMs);
    private held = false;
    private sized = false;
    private exactWhenStill = false;
    private contactShade = true;
    private exactNext = false;
    private sharpNext = false;
    private readonly layers: Layer[] = [];
    private drawn: ((view: View) => void)[] = [];
    private readonly afterNextFrame: ((time: number) => void)[] = [];
    private theme: 'dark' | 'light' = 'dark';
    private unit = '';
    /** While a figure is drawn, which has another size than the canvas. */
    private figureSize: ScreenSize | null = null;
    private outline: DomainOutline | null = null;
    private bounds: Bounds | null = null;
    /** Of other datasets, without numbers. */
    private otherOutlines: { bounds: Bounds; outline: DomainOutline }[] = [];
    private readonly scaleBar: ScaleBar;
    /** What lies over the picture, over that of a figure too. */
    private cover: Cover | null = null;

    constructor(options: FlowSceneOptions) {
        this.canvas = options.canvas;
        this.labels = options.labels;
        this.software = options.graphics.software;
        this.fullRatio = this.software ? 1 : Math.min(2, devicePixelRatio);
        this.movingResolution = new MovingResolution(this.fullRatio, this.software ? firstSoftwareRatio : this.fullRatio);
        this.renderer = createRenderer(options.canvas, options.graphics);
        this.places = samplePlaces(this.software ? 4 : 8);
        this.sampled = new SampledPicture(this.renderer);
        this.renderer.setPixelRatio(this.fullRatio);
        this.renderer.localClippingEnabled = true;
        this.picker = new SurfacePick(this.renderer, this.surfaces);
        this.rakes = new RakeLayer(options.labels);
        this.aim = new RakeAim(this.rakes, () => this.interaction.movable);
        this.interaction = new RakeInteraction({
            layer: this.rakes,
            aim: this.aim,
            view: () => this.view(),
            pick: (at) => this.pick(at)?.point ?? null,
            requestFrame: this.loop.request,
            onHold: (held) => this.hold(held),
        });
        // Before the camera controls, which must not see a press on a handle.
        this.pointerTools = new PointerTools(this.canvas);
        this.pointerTools.add(this.interaction);
        this.controls.connect(this.canvas);
        this.setTheme('dark');
        this.surfaces.attach(this.scene);
        this.scene.add(this.body.object);
        this.add(new Lights());
        this.add(this.rakes);
        this.add(this.aim);
        this.scaleBar = new ScaleBar(options.labels, () => this.controls.target);
        this.add(this.scaleBar);
        new ResizeObserver(() => this.resize()).observe(this.canvas);
        this.canvas.addEventListener('webglcontextrestored', this.loop.request);
    }

    get size(): ScreenSize {
        return this.figureSize ?? { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    }

    /** Pixels of the last picture for one of CSS, along one side: fewer while things move. */
    get pixelRatio(): number {
        return this.renderer.getPixelRatio();
    }

    /** Pictures that the last one is the mean of; 0: it moves. */
    get samples(): number {
        return this.sampled.count;
    }

    /** Returns whether the picture gets no better. */
    get isAtRest(): boolean {
        return this.sampled.count === this.places.length;
    }

    /** Camera and canvas as they are now. */
    view(): View {
        this.controls.camera.updateMatrixWorld();
        return new View(this.controls.camera, this.size, this.size, this.pixelRatio);
    }

    add(layer: Layer): void {
        this.layers.push(layer);
        this.scene.add(layer.object);
        this.loop.request();
    }

    remove(layer: Layer): void {
        this.layers.splice(this.layers.indexOf(layer), 1);
        this.scene.remove(layer.object);
        this.loop.request();
    }

    setTheme(theme: 'dark' | 'light'): void {
        this.theme = theme;
        this.scene.background = pictureColours[theme].background;
        for (const each of this.outlines) each.setColour(pictureColours[theme].outline);
        this.loop.request();
    }

    /** Sets the unit of lengths; empty: unknown. */
    setUnit(unit: string): void {
        this.unit = unit;
        this.outline?.setUnit(unit);
        this.scaleBar.setUnit(unit);
        this.loop.request();
    }

    /** An element that lies over the picture from now on; numbers make way for it. */
    watchCover(element: HTMLElement): void {
        const measure = (): void => {
            this.cover = coverOf(this.labels.getBoundingClientRect(), element.getBoundingClientRect());
            this.outline?.setCover(this.cover);
            this.loop.request();
        };
        const sizes = new ResizeObserver(measure);
        for (const each of [element, this.labels]) sizes.observe(each);
    }

    /** Sets whether a picture that stands still is drawn once more, with everything transparent in its exact
     *  order. */
    setExactWhenStill(on: boolean): void {
        if (on === this.exactWhenStill) return;
        this.exactWhenStill = on;
        this.loop.request();
    }

    /** Sets whether there is shade where things are near each other, in pictures that stand still and in
     *  figures. */
    setContactShade(on: boolean): void {
        if (on === this.contactShade) return;
        this.contactShade = on;
        this.loop.request();
    }

    /** Called after every frame. */
    onDraw(listener: (view: View) => void): () => void {
        this.drawn.push(listener);
        return () => (this.drawn = this.drawn.filter((each) => each !== listener));
    }

    /** @param stays the camera: only another dataset of the picture is worked on */
    setDomain(bounds: Bounds, stays = false): void {
        if (this.outline !== null) this.drop(this.outline);
        this.bounds = bounds;
        this.outline = new DomainOutline(bounds, this.labels, pictureColours[this.theme].outline);
        this.outline.setUnit(this.unit);
        this.outline.setCover(this.cover);
        this.add(this.outline);
        this.rakes.setBounds(bounds);
        this.aim.setFloor(bounds[4]);
        this.boundWhole(stays);
    }

    /** Of other datasets of which something is shown, too. */
    setOtherDomains(others: readonly Bounds[]): void {
        for (const { outline } of this.otherOutlines) this.drop(outline);
        const colour = pictureColours[this.theme].outline;
        this.otherOutlines = others.map((bounds) => ({ bounds, outline: new DomainOutline(bounds, null, colour) }));
        for (const { outline } of this.otherOutlines) this.add(outline);
        this.boundWhole(true);
    }

    private get outlines(): DomainOutline[] {
        return [...(this.outline === null ? [] : [this.outline]), ...this.otherOutlines.map(({ outline }) => outline)];
    }

    private drop(outline: DomainOutline): void {
        this.remove(outline);
        outline.dispose();
    }

    private boundWhole(stays: boolean): void {
        if (this.bounds === null) return;
        const whole = boundsRound([this.bounds, ...this.otherOutlines.map(({ bounds }) => bounds)]);
        if (stays) this.controls.widen(whole);
        else this.controls.setBounds(whole);
        this.surfaces.setBounds(whole);
    }

    /** Planes (n, w) that cut surfaces, and the body too if asked: nothing is left where n . point > w. */
    setClip(planes: readonly [number, number, number, number][], body: boolean): void {
        this.surfaces.setClip(planes, body);
        this.body.setClip(body ? planes : []);
        this.loop.request();
    }

    /** Shows what is new in a surface. */
    setSurface(id: string, change: TimedMeshChange): void {
        this.surfaces.set(id, change);
        this.movement.surfaceChanged(performance.now());
        this.loop.request();
    }

    removeSurface(id: string): void {
        this.surfaces.remove(id);
        this.loop.request();
    }

    /** `shown` is told when the next frame is on the screen as far as a page can know. */
    whenDrawn(shown: (time: number) => void): void {
        this.afterNextFrame.push(shown);
        this.loop.request();
    }

    /** Canvas position of a point, in CSS pixels; null behind the camera. */
    project(point: Vec3): ScreenPoint | null {
        return this.view().project(point);
    }

    /** Returns what is seen at a canvas position: a surface, the body, or a layer that can be pointed at. */
    pick(at: ScreenPoint): PickHit | null {
        const view = this.view();
        const others = this.layers.flatMap((layer) => layer.pick?.(view, at) ?? []).map((seen) => ({ ...noSurface, ...seen }));
        const hits = [this.picker.at(view, this.body.seen, at) ?? [], others].flat();
        return hits.sort((a, b) => a.distance - b.distance)[0] ?? null;
    }

    pickGrid(at: ScreenPoint, radiusPx: number, options: PickOptions): PickGrid {
        return this.picker.grid(this.view(), this.body.seen, at, radiusPx, options);
    }

    /** Draws at once, at full resolution, and returns the picture's pixels, RGBA from the bottom left. */
    readPixels(exact = false): { width: number; height: number; pixels: Uint8Array } {
        this.setPixelRatio(this.fullRatio);
        this.draw(exact);
        const gl = this.renderer.getContext() as WebGL2RenderingContext;
        const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
        const pixels = new Uint8Array(width * height * 4);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        if (this.samples > 0) this.sampled.show(this.controls.camera);
        return { width, height, pixels };
    }

    /**
     * Returns what is on the screen, cut to this shape and made as small. Drawn once more for that, because
     * browsers keep nothing of it; null where that takes long, or nothing can be seen.
     */
    copySmall({ width, height }: ScreenSize): HTMLCanvasElement | null {
        const exact = this.transparency === 'exact';
        const copy = document.createElement('canvas');
        const context = copy.getContext('2d');
        const { domElement: shown } = this.renderer;
        if (context === null || shown.width === 0 || shown.height === 0 || (exact && this.software)) return null;
        [copy.width, copy.height] = [width, height];
        this.setPixelRatio(this.fullRatio);
        if (this.isAtRest) this.sampled.show(this.controls.camera);
        else this.draw(exact);
        const scale = Math.min(shown.width / width, shown.height / height);
        const [wide, high] = [width * scale, height * scale];
        context.imageSmoothingQuality = 'high';
        context.drawImage(shown, (shown.width - wide) / 2, (shown.height - high) / 2, wide, high, 0, 0, width, height);
        return copy;
    }

    /**
     * For capture.ts: as if the canvas were of this size, with so many pixels for one of CSS, without what is
     * not for figures, with smooth edges, and with everything transparent in its exact order. `use` may draw
     * before several backgrounds, and part by part; the drawing is gone when it returns. `encoded`: see
     * SampledPicture.begin; `cover`: what will lie over it.
     */
    drawAside<T>(
        size: ScreenSize,
        pixelRatio: number,
        leftOut: (layer: Layer) => boolean,
        { encoded, cover }: { encoded: boolean; cover: Cover | null },
        use: (draw: (background: Color | null, part: Part) => void) => T,
    ): T {
        const { renderer, scene } = this;
        const [ratioBefore, backgroundBefore] = [renderer.getPixelRatio(), scene.background];
        const hidden = this.layers.filter((layer) => layer.object.visible && leftOut(layer));
        for (const { object } of hidden) object.visible = false;
        this.figureSize = size;
        this.outline?.setCover(cover);
        this.controls.setAspect(size.width / size.height);
        let drawn: ScreenSize = { width: 0, height: 0 };
        try {
            return use((background, part) => {
                scene.background = background ?? backgroundBefore;
                if (part.width !== drawn.width || part.height !== drawn.height) {
                    drawn = { width: part.width, height: part.height };
                    // Sizes are rounded down: a hair more keeps the last pixel.
                    const ratio = pixelRatio * (1 + 1e-9);
                    renderer.setDrawingBufferSize(part.width / pixelRatio, part.height / pixelRatio, ratio);
                }
                this.sampled.begin(encoded);
                for (let sample = 0; sample < this.places.length; ++sample) {
                    this.draw(true, { ...part, pixelRatio }, sample);
                    this.sampled.add(this.controls.camera);
                }
                this.sampled.show(this.controls.camera);
            });
        } finally {
            this.sampled.begin();
            this.figureSize = null;
            this.outline?.setCover(this.cover);
            scene.background = backgroundBefore;
            for (const { object } of hidden) object.visible = true;
            renderer.setPixelRatio(ratioBefore);
            this.resize();
        }
    }

    /** @param part the only one of the picture that is drawn @param sample which one of a mean, and shaded
     *  where things are near each other */
    private draw(exact = false, part: (Part & { pixelRatio: number }) | null = null, sample: number | null = null): void {
        const { camera, size } = this.view();
        if (size.width === 0 || size.height === 0) return;
        const drawn = part === null ? size : { width: part.width / part.pixelRatio, height: part.height / part.pixelRatio };
        const ratio = part?.pixelRatio ?? this.pixelRatio;
        const view = new View(camera, size, drawn, ratio);
        for (const layer of this.layers) layer.update(view);
        const { transparency, shade } = this.surfaces;
        transparency.exact = exact;
        this.surfaces.shared.pixelRatio.value = ratio;
        const [width, height] = [size.width * ratio, size.height * ratio];
        const { x, y, ...shown } = part ?? { x: 0, y: 0, width, height };
        const moved = this.places[sample ?? -1] ?? [0, 0];
        const shaded = sample !== null && this.contactShade;
        const looks = { samples: this.places.length, pairs: part === null ? pairs.page : pairs.figure, pixelRatio: ratio };
        shade.part = shaded ? { sample, ...looks, x, y, width, height } : null;
        camera.setViewOffset(width, height, x + moved[0], y + moved[1], shown.width, shown.height);
        try {
            this.renderer.render(this.scene, camera);
        } finally {
            camera.clearViewOffset();
        }
        this.transparency = !transparency.isNeeded ? 'none' : exact ? 'exact' : 'blended';
        for (const listener of this.drawn) listener(view);
    }

    private get awaitsExact(): boolean {
        return this.exactWhenStill && this.transparency === 'blended';
    }

    private drawFrame(finished: () => void, changed: boolean): void {
        if (!this.sized) finished();
        else if (changed || this.exactNext || this.sharpNext) this.redraw(finished);
        else if (this.samples > 0 && !this.isAtRest && !this.held) this.drawSmoother(finished);
        else finished();
    }

    private redraw(finished: () => void): void {
        const begun = performance.now();
        // What an empty picture and the first one take says nothing: programs are compiled, and another size would be waited for.
        const first = this.firstPictureMs === null;
        const quick = !this.exactNext && !this.sharpNext && (first || this.movement.at(begun));
        const moving = quick && !first;
        this.setPixelRatio(moving ? this.movingResolution.ratio : this.fullRatio);
        this.surfaces.setDoors(moving && this.movingResolution.sparing);
        this.rest.drawn(false);
        this.smoothness.drawn(false);
        this.sampled.begin();
        this.draw(this.exactNext, null, quick ? null : 0);
        this.surfaces.setDoors(false);
        ++this.framesDrawn;
        this.stillness.drawn(this.awaitsExact);
        if (!quick) this.sampled.add(this.controls.camera);
        [this.exactNext, this.sharpNext] = [false, false];
        const listeners = this.afterNextFrame.splice(0);
        whenDrawn(this.renderer.getContext() as WebGL2RenderingContext, (time) => {
            if (time !== null) this.pictureShown(time, moving ? time - begun : null);
            finished();
            if (this.outline !== null) this.firstPictureMs ??= time;
            if (time !== null) for (const listener of listeners) listener(time);
        });
    }

    /** The mean of what is on the screen and of the same once more, seen from elsewhere in each pixel. */
    private drawSmoother(finished: () => void): void {
        this.draw(this.transparency === 'exact', null, this.samples);
        this.sampled.add(this.controls.camera);
        this.sampled.show(this.controls.camera);
        whenDrawn(this.renderer.getContext() as WebGL2RenderingContext, () => {
            finished();
            this.loop.requestBetter();
        });
    }

    /** @param movingMs how long a picture of a movement took */
    private pictureShown(time: number, movingMs: number | null): void {
        this.movement.drawn(time);
        if (movingMs !== null) this.movingResolution.drawn(movingMs);
        const atLeastMs = Math.min(longestRestMs, picturesOfRest * (movingMs ?? 0));
        this.rest.drawn(this.pixelRatio < this.fullRatio || (this.samples === 0 && !this.held), atLeastMs);
        this.smoothness.drawn(this.samples > 0 && !this.awaitsExact);
    }

    private drawBetter(how: 'exactNext' | 'sharpNext'): void {
        this[how] = true;
        this.loop.request();
    }

    /** While something is moved, no picture may be late: none is exact. */
    hold(held: boolean): void {
        this.held = held;
        this.movement.hold(held);
        this.smoothness.hold(held);
        this.stillness.hold(held);
        if (held) this.exactNext = false;
        else this.loop.request();
    }

    private setPixelRatio(ratio: number): void {
        // Even the same one would clear the canvas.
        if (ratio !== this.pixelRatio) this.renderer.setPixelRatio(ratio);
    }

    private resize(): void {
        const { width, height } = this.size;
        if (width === 0 || height === 0) return;
        this.renderer.setSize(width, height, false);
        this.controls.resized(width / height);
        // At once: the canvas is blank after a change of size.
        if (this.sized) this.draw();
        this.sized = true;
        this.loop.request();
    }
}
