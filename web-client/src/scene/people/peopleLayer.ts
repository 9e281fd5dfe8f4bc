// The others in the picture: where they look from, as the lines of their camera, and what they point at, each
// in their colour and with their name.
import { Color, Group, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import type { Participant, Vec3 } from '../../protocol/messages.ts';
import { Labels } from '../base/labels.ts';
import type { Layer, View } from '../base/view.ts';
import { tintOf, WideLines } from '../base/wideLines.ts';
import { arrowTowards, edgeHint } from './edgeHint.ts';
import { frustumSegments, looksFromHere } from './frustum.ts';

const pointerRadiusPx = 6;
const nameGapPx = 14;
/** The buttons of view and tools are above and to the right. */
const hintInsets = { left: 8, right: 100, top: 48, bottom: 8 };
const frustumWidthPx = 1.5;

/** Describes what is drawn of one person. */
class Figure {
    readonly object = new Group();
    participant: Participant;
    readonly pointer: Mesh<SphereGeometry, MeshBasicMaterial>;
    readonly frustum = new WideLines({ width: frustumWidthPx, hidden: true });

    constructor(participant: Participant, sphere: SphereGeometry) {
        this.participant = participant;
        const overEverything = { depthTest: false, depthWrite: false, transparent: true };
        this.pointer = new Mesh(sphere, new MeshBasicMaterial(overEverything));
        this.pointer.renderOrder = 30;
        this.object.add(this.pointer, this.frustum.object);
        this.become(participant);
    }

    become(participant: Participant): void {
        this.participant = participant;
        const colour = new Color(participant.colour);
        this.pointer.material.color = colour;
        const { camera, pointer } = participant;
        const segments = camera === undefined || camera === null ? [] : frustumSegments(camera);
        this.pointer.visible = pointer !== undefined && pointer !== null;
        this.frustum.set(segments.flat(), Array.from({ length: segments.length / 2 }, () => tintOf(colour)).flat());
    }

    dispose(): void {
        this.pointer.material.dispose();
        this.frustum.dispose();
    }
}

export class PeopleLayer implements Layer {
    readonly object = new Group();
    readonly notForFigures = true;
    private readonly labels: Labels;
    private readonly sphere = new SphereGeometry(1, 16, 12);
    private readonly figures = new Map<string, Figure>();

    constructor(layer: HTMLElement) {
        this.labels = new Labels(layer);
    }

    /** All but the person at this page, and the one whose view it takes: their camera would fill the
     *  picture. */
    set(people: readonly Participant[]): void {
        const here = new Set(people.map(({ participant }) => participant));
        for (const [id, figure] of this.figures) {
            if (here.has(id)) continue;
            this.figures.delete(id);
            this.object.remove(figure.object);
            figure.dispose();
        }
        for (const person of people) {
            const known = this.figures.get(person.participant);
            if (known !== undefined) {
                known.become(person);
                continue;
            }
            const figure = new Figure(person, this.sphere);
            this.figures.set(person.participant, figure);
            this.object.add(figure.object);
        }
    }

    update(view: View): void {
        this.labels.begin();
        for (const { participant, pointer, frustum } of this.figures.values()) {
            const { pointer: pointsAt = null, camera = null } = participant;
            const eye = camera !== null && !looksFromHere(view, camera) ? camera.position : null;
            frustum.object.visible = eye !== null;
            frustum.update(view);
            if (pointsAt !== null) {
                pointer.position.set(...pointsAt);
                pointer.scale.setScalar(view.worldPerPx(pointsAt) * pointerRadiusPx);
                this.name(view, pointsAt, participant);
            }
            if (eye !== null) this.name(view, eye, participant);
            this.hint(
                view,
                [pointsAt, eye].filter((place) => place !== null),
                participant,
            );
        }
        this.labels.end();
    }

    /** A user of whom nothing is in the picture, at the edge of it: towards what they point at, else where
     *  they look from. */
    private hint(view: View, places: readonly Vec3[], { name, colour }: Participant): void {
        const hints = places.map((place) => edgeHint(view, place, hintInsets));
        const [hint] = hints;
        if (hint === undefined || hint === null || hints.includes(null)) return;
        const { at, share, towards } = hint;
        const arrow = arrowTowards(towards);
        const label = this.labels.place(at, towards.x < 0 ? `${arrow} ${name}` : `${name} ${arrow}`, 'person', share);
        label.style.borderColor = colour;
    }

    private name(view: View, at: Vec3, { name, colour }: Participant): void {
        const seen = view.project(at);
        if (seen === null) return;
        const label = this.labels.place({ x: seen.x, y: seen.y - nameGapPx }, name, 'person');
        label.style.borderColor = colour;
    }
}
