// Lists of records and rows of a name with buttons behind it.
import { css } from 'lit';

export const listStyles = css`
    ul {
        margin: 0;
        padding: 0;
        list-style: none;
    }
    .row {
        display: flex;
        align-items: center;
        gap: 6px;
    }
    .row > :first-child {
        flex: 1;
    }
    .quiet {
        color: var(--quiet);
    }
`;
