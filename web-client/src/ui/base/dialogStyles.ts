// Dialogs over the page, which end in a row of buttons.
import { css } from 'lit';

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
