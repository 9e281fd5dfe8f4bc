// Elements of the page: they look alike, and render again when a signal that they have read changes.
import { effect } from '@preact/signals-core';
import { type CSSResultGroup, type CSSResultOrNative, LitElement, type PropertyDeclarations } from 'lit';
import { sharedStyles } from './sharedStyles.ts';

export abstract class SignalElement extends LitElement {
    private stopWatching: (() => void) | null = null;

    /** Puts the styles of an element after those that all share. */
    protected static override finalizeStyles(own: CSSResultGroup = []): CSSResultOrNative[] {
        return super.finalizeStyles([sharedStyles, own]);
    }

    protected override performUpdate(): void {
        if (!this.isUpdatePending) return;
        this.stopWatching?.();
        let rendering = true;
        this.stopWatching = effect(() => {
            if (!rendering) {
                // Not here: several signals may change before the next rendering.
                this.requestUpdate();
                return;
            }
            rendering = false;
            super.performUpdate();
        });
    }

    override connectedCallback(): void {
        super.connectedCallback();
        this.requestUpdate();
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.stopWatching?.();
        this.stopWatching = null;
    }
}

/** An element that is handed what it uses as its model. */
export abstract class ModelElement<Model> extends SignalElement {
    static override properties: PropertyDeclarations = { model: { attribute: false } };
    declare model: Model;
}
