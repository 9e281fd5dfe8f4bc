// The few signs on buttons, drawn: fonts do not agree on them.
import { html, svg, type TemplateResult } from 'lit';

const paths = {
    play: 'M4 2.5v11l9-5.5z',
    pause: 'M4 3h3v10H4zM9 3h3v10H9z',
    back: 'M11.5 3v10L5 8zM3 3h1.6v10H3z',
    forward: 'M4.5 3v10L11 8zM11.4 3H13v10h-1.6z',
    start: 'M2 3h1.6v10H2zM9 3v10L3.8 8zM14.5 3v10L9.3 8z',
    end: 'M12.4 3H14v10h-1.6zM7 3v10l5.2-5zM1.5 3v10l5.2-5z',
    seen: 'M8 3.5C4.5 3.5 2 6 1 8c1 2 3.5 4.5 7 4.5s6-2.5 7-4.5c-1-2-3.5-4.5-7-4.5zM8 5.5a2.5 2.5 0 1 1 0 5 2.5 2.5 0 0 1 0-5z',
    hidden: 'M2.7 1.6 14.4 13.3l-1.1 1.1L1.6 2.7zM8 3.5c3.5 0 6 2.5 7 4.5-.5 1-1.3 2.1-2.4 2.900L6 4.2c.6-.2 1.3-.7 2-.7zM3.2 5.2l6.6 6.7c-.6.3-1.2.6-1.800.6-3.5 0-6-2.5-7-4.5.5-1 1.2-2 2.2-2.800z',
    locked: 'M4 7V5a4 4 0 0 1 8 0v2h1v7H3V7zm2 0h4V5a2 2 0 0 0-4 0z',
    free: 'M4 7V5a4 4 0 0 1 7.7-1.5l-1.800.8A2 2 0 0 0 6 5v2h7v7H3V7z',
    only: 'M8 1a7 7 0 1 1 0 14A7 7 0 0 1 8 1zm0 1.6a5.4 5.4 0 1 0 0 10.8A5.4 5.4 0 0 0 8 2.6zM8 5.2a2.8 2.8 0 1 1 0 5.6 2.8 2.8 0 0 1 0-5.6z',
    fold: 'M5 2.5 11 8l-6 5.5z',
    unfold: 'M11 2.5v11L5 8z',
    whole: 'M2 2h5v1.6H3.6V7H2zM9 2h5v5h-1.6V3.6H9zM2 9h1.6v3.4H7V14H2zM12.4 9H14v5H9v-1.6h3.4z',
} as const;

export type IconName = keyof typeof paths;

export function icon(name: IconName): TemplateResult {
    return html`<svg viewBox="0 0 16 16" width="16" height="16" fill="currentColor" aria-hidden="true">
        ${svg`<path d=${paths[name]} />`}
    </svg>`;
}
