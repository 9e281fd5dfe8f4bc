// Holds what the three parts of the tab "Export" have in common.
import { css } from 'lit';

export const exportStyles = css`
    :host {
        display: block;
    }
    .row,
    .check {
        margin-top: 6px;
    }
    div.row {
        justify-content: flex-start;
        flex-wrap: wrap;
    }
    select {
        max-width: 100%;
    }
    input.number {
        width: 84px;
        text-align: right;
        font-variant-numeric: tabular-nums;
    }
    .check {
        gap: 6px;
    }
    .check input {
        width: 16px;
        height: 16px;
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
    }
    p[role='alert'] {
        color: var(--warm);
    }
`;
