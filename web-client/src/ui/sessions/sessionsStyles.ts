// Lays out the list of sessions: cards with a picture each, in as many columns as there is room for.
import { css } from 'lit';

export const sessionsStyles = css`
    dialog {
        flex-direction: column;
        width: min(980px, 94vw);
        height: min(760px, 90vh);
        padding: 0;
        overflow: hidden;
    }
    dialog[open] {
        display: flex;
    }
    .head,
    .foot {
        display: flex;
        flex-wrap: wrap;
        gap: 8px 12px;
        align-items: center;
        padding: 12px 18px;
    }
    .head {
        border-bottom: 1px solid var(--line);
    }
    .foot {
        border-top: 1px solid var(--line);
    }
    h2 {
        flex: 1;
        margin: 0;
        font-size: 17px;
    }
    .choice {
        display: flex;
        gap: 2px;
        padding: 2px;
        border: 1px solid var(--line);
        border-radius: 8px;
    }
    .choice button {
        min-height: 26px;
        padding: 2px 12px;
        border: 0;
        background: none;
        color: var(--quiet);
    }
    .choice button[aria-pressed='true'] {
        background: var(--raised);
        color: var(--text);
        font-weight: 600;
    }
    form {
        display: flex;
        flex: 1;
        flex-wrap: wrap;
        gap: 6px;
    }
    form input {
        flex: 1 1 180px;
        min-width: 0;
        max-width: 320px;
    }
    .said {
        display: flex;
        gap: 12px;
        align-items: center;
        margin: 10px 18px 0;
        padding: 7px 12px;
        border: 1px solid var(--line);
        border-left: 4px solid var(--good);
        border-radius: 8px;
        background: var(--raised);
    }
    .said.problem {
        border-left-color: var(--warm);
    }
    .said .words {
        flex: 1;
    }
    .list {
        flex: 1;
        overflow-y: auto;
        padding: 14px 18px 18px;
    }
    .list > p {
        margin: 0 0 12px;
    }
    .search {
        width: 240px;
        margin: 0 0 12px;
    }
    ul {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(272px, 1fr));
        gap: 14px;
    }
    .card {
        display: flex;
        flex-direction: column;
        overflow: hidden;
        border: 1px solid var(--line);
        border-radius: 10px;
        background: var(--raised);
        content-visibility: auto;
        contain-intrinsic-size: auto 320px;
    }
    .card.here {
        border-color: var(--accent);
    }
    .picture {
        display: block;
        width: 100%;
        aspect-ratio: 16 / 10;
        padding: 0;
        border: 0;
        border-bottom: 1px solid var(--line);
        border-radius: 0;
        overflow: hidden;
        background: light-dark(#e4eaf2, #0b1018);
        color: var(--quiet);
    }
    .picture:focus-visible {
        outline-offset: -3px;
    }
    .trash .picture wakesurf-session-picture {
        opacity: 0.55;
    }
    .about {
        display: flex;
        flex: 1;
        flex-direction: column;
        gap: 2px;
        padding: 9px 11px 10px;
    }
    .about p {
        margin: 0;
    }
    .name {
        display: flex;
        gap: 8px;
        align-items: baseline;
        font-size: 14px;
        font-weight: 600;
    }
    .name > span:first-child {
        flex: 1;
    }
    .badge {
        flex: none;
        padding: 0 7px;
        border-radius: 9px;
        background: var(--accent);
        color: light-dark(#ffffff, #06131b);
        font-size: 11px;
    }
    .people {
        display: flex;
        gap: 4px;
        align-items: center;
        min-height: 18px;
    }
    .dot {
        flex: none;
        width: 9px;
        height: 9px;
        border-radius: 5px;
    }
    .actions {
        display: flex;
        flex-wrap: wrap;
        gap: 5px;
        margin-top: auto;
        padding-top: 7px;
    }
    .actions button {
        min-height: 25px;
        padding: 1px 6px;
        font-size: 12px;
    }
    .rename {
        gap: 5px;
    }
    .rename input {
        flex: 1 1 100%;
        max-width: none;
    }
    .asked {
        color: var(--warm);
    }
`;
