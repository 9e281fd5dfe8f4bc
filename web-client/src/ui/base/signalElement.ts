// Elements of the page: they look alike, in light and dark surroundings, and render again when a signal that they have read changes.
import { effect } from '@preact/signals-core';
import { css, type CSSResultGroup, type CSSResultOrNative, LitElement, type PropertyDeclarations } from 'lit';

export const sharedStyles = css`
    :host {
        --ground: light-dark(#f6f8fb, #141b27);
        --raised: light-dark(#ffffff, #1c2534);
        --line: light-dark(#cfd7e3, #2e3a4e);
        --text: light-dark(#17202d, #e8edf5);
        --quiet: light-dark(#4b5a70, #a7b4c8);
        --accent: light-dark(#0b6e99, #58c4f0);
        --warm: light-dark(#b3400e, #ff9a6b);
        --good: light-dark(#17713f, #5fd39a);
        color: var(--text);
        font-size: 13px;
        line-height: 1.4;
    }
    * {
        box-sizing: border-box;
    }
    [hidden] {
        display: none !important;
    }
    button,
    input,
    select {
        font: inherit;
        color: inherit;
    }
    button,
    select,
    input:not([type]) {
        min-height: 28px;
        padding: 3px 8px;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--raised);
    }
    button {
        cursor: pointer;
    }
    :disabled {
        color: var(--quiet);
        cursor: not-allowed;
    }
    button:disabled,
    select:disabled,
    input:disabled {
        border-style: dashed;
        background: none;
        opacity: 0.6;
    }
    button:enabled:hover {
        border-color: var(--accent);
    }
    /* Where the system chooses colours, grounds and borders of the page are gone. */
    @media (forced-colors: active) {
        [aria-pressed='true'],
        [aria-selected='true'] {
            forced-color-adjust: none;
            background: Highlight;
            color: HighlightText;
        }
    }
    input[type='range'] {
        width: 100%;
        height: 24px;
        margin: 0;
        accent-color: var(--accent);
    }
    progress {
        accent-color: var(--accent);
    }
    ul {
        margin: 0;
        padding: 0;
        list-style: none;
    }
    dl {
        display: grid;
        grid-template-columns: auto 1fr;
        gap: 2px 12px;
        margin: 0;
    }
    dt,
    .quiet {
        color: var(--quiet);
    }
    dd {
        margin: 0;
        text-align: right;
    }
    dd,
    .value {
        font-variant-numeric: tabular-nums;
    }
    summary {
        cursor: pointer;
    }
    /* A name with something behind it, and a box before its words. */
    .row {
        display: flex;
        justify-content: space-between;
        align-items: center;
        gap: 8px;
    }
    /* What is chosen is read as a whole, below its label where there is no room beside it. */
    .row:has(> select) {
        flex-wrap: wrap;
    }
    .row > select {
        max-width: 100%;
    }
    .check {
        display: flex;
        align-items: center;
        gap: 8px;
    }
    .check input {
        margin: 0;
        accent-color: var(--accent);
    }
    .hint {
        margin: 6px 0 0;
        color: var(--quiet);
        font-size: 12px;
    }
    /* Words that end in dots where there is no room. */
    .cut {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
    }
    /* A number among others, where there is little room. */
    input.narrow {
        width: 100%;
        min-width: 0;
        padding: 3px 6px;
        text-align: right;
        font-variant-numeric: tabular-nums;
    }
    :focus-visible {
        outline: 2px solid var(--accent);
        outline-offset: 2px;
    }
`;

/** Dialogs over the page end in a row of buttons. */
export const dialogStyles = css`
    dialog {
        padding: 16px 20px;
        border: 1px solid var(--line);
        border-radius: 10px;
        background: var(--ground);
        color: var(--text);
    }
    dialog::backdrop {
        background: rgb(0 0 0 / 0.4);
    }
    .answers {
        display: flex;
        justify-content: flex-end;
        gap: 8px;
        margin-top: 12px;
    }
`;

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
