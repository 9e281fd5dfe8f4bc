// Colours and controls that all components share, for light and dark surroundings.
import { css } from 'lit';

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
    input[type='number'],
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
    input[type='range'] {
        width: 100%;
        height: 24px;
        margin: 0;
        accent-color: var(--accent);
    }
    :focus-visible {
        outline: 2px solid var(--accent);
        outline-offset: 2px;
    }
`;
