// Lays out the rake's numbers and buttons.
import { css } from 'lit';

export const rakePanelStyles = css`
    fieldset {
        display: contents;
    }
    .pair {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 10px;
    }
    .pair label {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr);
        gap: 8px;
        align-items: center;
    }
    .row {
        margin-top: 8px;
    }
    .row input,
    .row select {
        width: 84px;
    }
    select {
        min-width: 0;
    }
    .point {
        display: grid;
        grid-template-columns: 62px repeat(3, minmax(0, 1fr));
        gap: 6px;
        align-items: center;
        margin-top: 6px;
    }
    .point input.long {
        padding-inline: 2px;
        font-size: 11px;
        letter-spacing: -0.2px;
    }
    .handle {
        padding-inline: 2px;
    }
    [aria-pressed='true'] {
        border-color: var(--accent);
        box-shadow: inset 0 0 0 1px var(--accent);
    }
    .turn {
        grid-template-columns: 62px 1fr 1fr;
    }
    .heads {
        margin: 8px 0 -6px;
        color: var(--quiet);
        text-align: center;
    }
    .tools {
        margin-top: 10px;
        padding: 2px 10px 10px;
        border: 1px solid var(--line);
        border-radius: 8px;
    }
    .nudges {
        display: grid;
        grid-template-columns: repeat(6, minmax(0, 1fr));
        gap: 4px;
        margin-top: 8px;
    }
    .nudges.two {
        grid-template-columns: 1fr 1fr;
    }
    .nudges button {
        padding-inline: 2px;
    }
    .wide {
        width: 100%;
        margin-top: 8px;
    }
    .check {
        margin-top: 10px;
        cursor: pointer;
    }
`;
