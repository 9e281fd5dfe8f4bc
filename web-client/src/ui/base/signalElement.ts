// A lit element that renders again when a signal it has read changes.
import { effect } from '@preact/signals-core';
import { LitElement } from 'lit';

export abstract class SignalElement extends LitElement {
    private stopWatching: (() => void) | null = null;

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
