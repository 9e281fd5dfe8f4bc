// Lays out the time bar.
import { css } from 'lit';

export const timeBarStyles = css`
    :host {
        display: block;
        padding: 6px 10px 4px;
        background: var(--ground);
        border-top: 1px solid var(--line);
    }
    .row {
        flex-wrap: wrap;
        justify-content: normal;
        gap: 4px 10px;
        min-height: 28px;
    }
    .buttons {
        display: flex;
        gap: 3px;
    }
    .buttons button {
        display: grid;
        place-content: center;
        width: 29px;
        padding: 0;
    }
    button:disabled {
        opacity: 0.45;
        cursor: default;
    }
    [aria-pressed='true'] {
        border-color: var(--accent);
        color: var(--accent);
    }
    #speed {
        max-width: 150px;
    }
    input.number {
        field-sizing: content;
        min-width: 74px;
        max-width: 150px;
        text-align: right;
        font-variant-numeric: tabular-nums;
    }
    label {
        display: flex;
        align-items: center;
        gap: 6px;
    }
    .words {
        font-variant-numeric: tabular-nums;
    }
    .quiet,
    .below {
        color: var(--quiet);
        font-size: 12px;
    }
    .below {
        justify-content: space-between;
        min-height: 24px;
    }
    .legend {
        display: flex;
        flex-wrap: wrap;
        gap: 2px 12px;
    }
    .legend svg {
        margin-right: 4px;
        vertical-align: -1px;
    }
    .legend rect {
        fill: none;
        stroke: currentColor;
    }
    .legend path {
        fill: currentColor;
    }
    wakesurf-copy-as {
        margin: 0;
    }
    /* Scripts are for where there are terminals; the signs of the marks are in the timeline's own words. */
    @media (max-width: 500px), (max-height: 500px) {
        #speed {
            max-width: 112px;
        }
        wakesurf-copy-as,
        .legend [aria-hidden] {
            display: none;
        }
    }
`;
