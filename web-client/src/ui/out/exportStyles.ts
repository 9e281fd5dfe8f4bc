// What the three parts of the tab "Export" have in common.
import { css } from 'lit';

export const exportStyles = css`
    :host {
        display: block;
    }
    label,
    .row {
        display: flex;
        justify-content: space-between;
        align-items: center;
        gap: 8px;
        margin-top: 6px;
    }
    .row {
        justify-content: flex-start;
        flex-wrap: wrap;
    }
    select {
        max-width: 210px;
    }
    input[type='number'] {
        width: 84px;
        text-align: right;
        font-variant-numeric: tabular-nums;
    }
    input[type='checkbox'] {
        width: 16px;
        height: 16px;
        margin: 0 6px 0 0;
        accent-color: var(--accent);
    }
    label.check {
        justify-content: flex-start;
        gap: 0;
    }
    .checks {
        display: grid;
        grid-template-columns: 1fr 1fr;
    }
    button {
        min-width: 68px;
    }
    progress {
        width: 100%;
        accent-color: var(--accent);
    }
    p {
        margin: 6px 0 0;
        color: var(--quiet);
        font-size: 12px;
    }
    p[role='alert'] {
        color: var(--warm);
    }
`;
