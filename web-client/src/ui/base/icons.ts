// The few signs on buttons, drawn: fonts do not agree on them.
import { html, svg, type TemplateResult } from 'lit';

const paths = {
    play: 'M4 2.5v11l9-5.5z',
    pause: 'M4 3h3v10H4zM9 3h3v10H9z',
    back: 'M11.5 3v10L5 8zM3 3h1.6v10H3z',
    forward: 'M4.5 3v10L11 8zM11.4 3H13v10h-1.6z',
    start: 'M2 3h1.6v10H2zM9 3v10L3.8 8zM14.5 3v10L9.3 8z',
    end: 'M12.4 3H14v10h-1.6zM7 3v10l5.2-5zM1.5 3v10l5.2-5z',
} as const;

export function icon(name: keyof typeof paths): TemplateResult {
    return html`<svg viewBox="0 0 16 16" width="16" height="16" fill="currentColor" aria-hidden="true">
        ${svg`<path d=${paths[name]} />`}
    </svg>`;
}
