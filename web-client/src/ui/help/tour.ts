// Leads a first visit through the page, one card at a time, without standing in the way: whatever it speaks
// of can be done while it is there, and it can be sent away.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import { keep, recall } from '../../state/browserMemory.ts';
import type { ViewState } from '../../state/viewState.ts';
import { ModelElement } from '../base/signalElement.ts';
import { isInFrame } from '../view/room.ts';
import { type TourFacts, type TourStart, tourStart, tourSteps } from './tourSteps.ts';

const kept = 'tour';

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
        if (recall(kept) === null && view.tourStep.value === null && !isInFrame()) view.tourStep.value = 0;
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
        keep(kept, 'done');
    }
}

customElements.define('wakesurf-tour', Tour);
