// Three numbers of a place in space, each in a field of its own.
import { html, type TemplateResult } from 'lit';
import type { Vec3 } from '../protocol/messages.ts';

const axes = ['x', 'y', 'z'] as const;

/** Fields for a point; what is no number is not told. @param name of the point, before the axis */
export function vectorInput(name: string, point: Vec3, changed: (point: Vec3) => void): TemplateResult {
    return html`<div class="vector" role="group" aria-label=${name}>
        ${axes.map(
            (axis, k) =>
                html`<input
                    type="number"
                    step="any"
                    aria-label=${`${name} ${axis}`}
                    .value=${String(Number((point[k] ?? 0).toPrecision(5)))}
                    @change=${(event: Event) => {
                        const value = (event.target as HTMLInputElement).valueAsNumber;
                        const moved: Vec3 = [...point];
                        moved[k] = value;
                        if (Number.isFinite(value)) changed(moved);
                    }}
                />`,
        )}
    </div>`;
}
