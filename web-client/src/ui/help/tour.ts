// Leads a first visit through the page, from dragging the rake to showing the result to another user, one card at a time, without standing
// in the way: whatever it speaks of can be done while it is there, and it can be sent away.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { SurfaceKind } from '../../protocol/messages.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { Edits } from '../../session/edits/edits.ts';
import type { Playback } from '../../session/time/playback.ts';
import type { AppState } from '../../state/appState.ts';
import { keep, recall } from '../../state/browserMemory.ts';
import type { ViewState } from '../../state/viewState.ts';
import { ModelElement } from '../base/signalElement.ts';
import { isInFrame } from '../view/room.ts';

const tourKey = 'tour';

export interface TourModel extends Omit<TourFacts, 'touch' | 'narrow'> {
    state: TourFacts['state'] & Pick<AppState, 'role' | 'stage'>;
    view: Pick<ViewState, 'looks' | 'tourStep'>;
    scene: Pick<FlowScene, 'controls' | 'onDraw'>;
}

export class Tour extends ModelElement<TourModel> {
    private start: { step: number; before: TourStart } | null = null;

    static override styles = css`
        section {
            width: 300px;
            padding: 12px 14px;
            border: 1px solid var(--line);
            border-left: 4px solid var(--accent);
            border-radius: 8px;
            background: var(--ground);
            box-shadow: 0 6px 24px rgb(0 0 0 / 0.35);
        }
        h2 {
            margin: 0 0 4px;
            font-size: 14px;
        }
        p {
            margin: 0 0 10px;
        }
        .quiet {
            flex: 1;
        }
        @media (max-width: 760px), (max-height: 500px) {
            section {
                width: auto;
                padding: 8px 12px;
            }
            p {
                margin-bottom: 6px;
            }
        }
    `;

    override connectedCallback(): void {
        super.connectedCallback();
        const { view } = this.model;
        if (recall(tourKey) === null && view.tourStep.value === null && !isInFrame()) view.tourStep.value = 0;
    }

    override render(): TemplateResult | typeof nothing {
        const { state, view } = this.model;
        const at = view.tourStep.value;
        const step = tourSteps[at ?? -1];
        const mayEdit = state.role.value !== 'viewer';
        if (at === null || step === undefined || state.stage.value !== 'running' || !mayEdit) return nothing;
        const facts: TourFacts = {
            ...this.model,
            touch: matchMedia('(pointer: coarse)').matches,
            narrow: matchMedia('(max-width: 760px)').matches,
        };
        if (this.start?.step !== at) this.start = { step: at, before: tourStart(facts) };
        if (step.done(facts, this.start.before)) queueMicrotask(() => this.goTo(at + 1));
        const last = at === tourSteps.length - 1;
        return html`<section aria-label="Tour" data-step=${step.id}>
            <div aria-live="polite">
                <h2>${step.title}</h2>
                <p>${step.words(facts)}</p>
            </div>
            <div class="row">
                <span class="quiet">${at + 1} of ${tourSteps.length}</span>
                ${last ? nothing : html`<button type="button" @click=${() => this.end()}>Skip the tour</button>`}
                <button type="button" @click=${() => this.goTo(at + 1)}>${last ? 'Done' : 'Next'}</button>
            </div>
        </section>`;
    }

    protected override firstUpdated(): void {
        // Turning the view is no signal.
        this.model.scene.onDraw(() => {
            if (this.model.view.tourStep.value !== null) this.requestUpdate();
        });
    }

    private goTo(step: number): void {
        if (step >= tourSteps.length) this.end();
        else this.model.view.tourStep.value = step;
    }

    private end(): void {
        this.model.view.tourStep.value = null;
        keep(tourKey, 'done');
    }
}

customElements.define('wakesurf-tour', Tour);

/** What the steps look at to see what the user has done. */
export interface TourFacts {
    state: Pick<AppState, 'rakes' | 'dataset' | 'times' | 'participants'>;
    view: Pick<ViewState, 'looks'>;
    edits: Pick<Edits, 'intent'>;
    playback: Pick<Playback, 'playing'>;
    scene: Pick<FlowScene, 'controls'>;
    /** Fingers, not a mouse. */
    touch: boolean;
    /** The panel is below the picture, not beside it. */
    narrow: boolean;
}

export interface TourStep {
    id: string;
    title: string;
    words: (facts: TourFacts) => string;
    /** Returns whether the user has done it; the tour goes on by itself then. */
    done: (facts: TourFacts, before: TourStart) => boolean;
}

/** How things stood when the step began. */
export interface TourStart {
    rakeRevisions: string;
    pose: string;
    looks: ViewState['looks']['value'];
    kind: SurfaceKind | undefined;
}

function tourStart({ state, scene, view, edits }: Omit<TourFacts, 'touch' | 'narrow'>): TourStart {
    const revisions = [...state.rakes.value.values()].map(({ rake, rev }) => `${rake} ${rev}`);
    return {
        rakeRevisions: revisions.join(),
        pose: JSON.stringify(scene.controls.pose),
        looks: view.looks.value,
        kind: edits.intent.value?.kind,
    };
}

export const tourSteps: readonly TourStep[] = [
    {
        id: 'drag',
        title: 'Drag the rake',
        words: () =>
            'The line with the round handles releases particles; the sheet shows where they go. ' +
            'Drag a handle: the surface follows, coarse at first, then final.',
        done: (facts, before) => tourStart(facts).rakeRevisions !== before.rakeRevisions,
    },
    {
        id: 'turn',
        title: 'Look around',
        words: ({ touch }) =>
            touch
                ? 'Drag beside the rake with one finger to rotate the view, with two fingers to pan, and pinch to zoom.'
                : 'Drag beside the rake to rotate the view, drag with the right button to pan, and scroll to zoom.',
        done: (facts, before) => tourStart(facts).pose !== before.pose,
    },
    {
        id: 'play',
        title: 'Watch it move',
        words: ({ state }) =>
            'Press play under the picture' +
            (state.dataset.value?.obstacle === true ? ' and watch the sheet tear around the body' : '') +
            '. Everyone in the session sees the same time.',
        done: ({ playback }) => playback.playing.value,
    },
    {
        id: 'kind',
        title: 'Choose another surface',
        words: ({ state, edits, narrow }) => {
            const where = `${narrow ? 'Below the picture' : 'On the right'}, under Flow, choose`;
            if (state.dataset.value?.steady === true || state.times.value.length < 2) {
                return 'This flow does not change with time. In a flow that does, a streak surface shows particles released one after another, like smoke.';
            }
            return edits.intent.value?.kind === 'streak'
                ? `This is a streak surface: particles released one after another, like smoke. ${where} Stream to see where they would go if the flow stood still.`
                : `${where} Streak: particles released one after another, like smoke. It moves with the flow.`;
        },
        done: ({ edits }, before) => edits.intent.value?.kind !== before.kind,
    },
    {
        id: 'look',
        title: 'Make it readable',
        words: () =>
            'Under Look, colour the surface by another field (by Q, vortices are red), make it transparent, or draw lines on it.',
        done: ({ view }, before) => view.looks.value !== before.looks,
    },
    {
        id: 'share',
        title: 'Show it to someone',
        words: () =>
            'Under Share, make a link: anyone who opens it sees this view and may drag rakes too. ' +
            'Under Export, save pictures, films and meshes.',
        done: ({ state }) => state.participants.value.size > 1,
    },
];
