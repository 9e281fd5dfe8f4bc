// Points in space that a user has set: where was probed, what was measured, where words stand. They keep
// their size on the screen and show through what is before them.
import { Color, Group, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { Labels } from '../base/labels.ts';
import type { Layer, View } from '../base/view.ts';
import { tintOf, WideLines } from '../base/wideLines.ts';

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
const lineWidthPx = 1.5;
const wordsGapPx = 16;

export class MarkerLayer implements Layer {
    readonly object = new Group();
    private readonly labels: Labels;
    private readonly sphere = new SphereGeometry(1, 16, 12);
    private readonly dots: Mesh<SphereGeometry, MeshBasicMaterial>[] = [];
    private readonly lines = new WideLines({ width: lineWidthPx, hidden: false });
    private markers: readonly Marker[] = [];
    private marked: readonly MarkedLine[] = [];

    /** @param layer takes the words */
    constructor(layer: HTMLElement) {
        this.labels = new Labels(layer);
        this.lines.object.renderOrder = 31;
        this.object.add(this.lines.object);
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
        this.lines.set(
            lines.flatMap(({ from, to }) => [...from, ...to]),
            lines.flatMap(({ colour }) => tintOf(new Color(colour))),
        );
    }

    update(view: View): void {
        this.lines.update(view);
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

    private say(view: View, at: Vec3, words: string, colour: string): void {
        const seen = view.project(at);
        if (seen === null || words === '') return;
        const label = this.labels.place({ x: seen.x, y: seen.y - wordsGapPx }, words, 'marker');
        label.style.borderColor = colour;
    }
}
