// Points in space that someone has set: where was probed, what was measured, where words stand. They keep their size on the
// screen and show through what is before them.
import {
    BufferAttribute,
    BufferGeometry,
    Color,
    Group,
    LineBasicMaterial,
    LineSegments,
    Mesh,
    MeshBasicMaterial,
    SphereGeometry,
} from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { Labels } from '../base/labels.ts';
import type { Layer, View } from '../base/view.ts';

export interface Marker {
    at: Vec3;
    /** #rrggbb */
    colour: string;
    words: string;
}

export interface MarkedLine {
    from: Vec3;
    to: Vec3;
    colour: string;
    /** In the middle. */
    words: string;
}

const radiusPx = 5;
const wordsGapPx = 16;

export class MarkerLayer implements Layer {
    readonly object = new Group();
    private readonly labels: Labels;
    private readonly sphere = new SphereGeometry(1, 16, 12);
    private readonly dots: Mesh<SphereGeometry, MeshBasicMaterial>[] = [];
    private readonly lines: LineSegments<BufferGeometry, LineBasicMaterial>;
    private markers: readonly Marker[] = [];
    private marked: readonly MarkedLine[] = [];

    /** @param layer takes the words */
    constructor(layer: HTMLElement) {
        this.labels = new Labels(layer);
        const material = new LineBasicMaterial({ vertexColors: true, depthTest: false, transparent: true });
        this.lines = new LineSegments(new BufferGeometry(), material);
        this.lines.frustumCulled = false;
        this.lines.renderOrder = 31;
        this.object.add(this.lines);
    }

    set(markers: readonly Marker[], lines: readonly MarkedLine[] = []): void {
        this.markers = markers;
        this.marked = lines;
        while (this.dots.length < markers.length) {
            const dot = new Mesh(this.sphere, new MeshBasicMaterial({ depthTest: false, transparent: true }));
            dot.renderOrder = 32;
            this.dots.push(dot);
            this.object.add(dot);
        }
        this.dots.forEach((dot, i) => {
            const marker = markers[i];
            dot.visible = marker !== undefined;
            if (marker === undefined) return;
            dot.position.set(...marker.at);
            dot.material.color.set(marker.colour);
        });
        this.fillLines();
    }

    update(view: View): void {
        this.labels.begin();
        this.markers.forEach(({ at, words, colour }, i) => {
            this.dots[i]?.scale.setScalar(view.worldPerPx(at) * radiusPx);
            this.say(view, at, words, colour);
        });
        for (const { from, to, words, colour } of this.marked) {
            this.say(view, from.map((value, i) => (value + to[i]!) / 2) as Vec3, words, colour);
        }
        this.labels.end();
    }

    private fillLines(): void {
        const { geometry } = this.lines;
        const positions = this.marked.flatMap(({ from, to }) => [...from, ...to]);
        const colours = this.marked.flatMap(({ colour }) => {
            const { r, g, b } = new Color(colour);
            return [r, g, b, r, g, b];
        });
        geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
        geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 3));
        this.lines.visible = positions.length > 0;
    }

    private say(view: View, at: Vec3, words: string, colour: string): void {
        const seen = view.project(at);
        if (seen === null || words === '') return;
        const label = this.labels.place({ x: seen.x, y: seen.y - wordsGapPx }, words, 'marker');
        label.style.borderColor = colour;
    }
}
