// Three numbers of a place in space, each in a field of its own.
import { html, type TemplateResult } from 'lit';
import type { Vec3 } from '../../protocol/messages.ts';

const axes = ['x', 'y', 'z'] as const;

/**
 * Fields for a point; what is no number is not told, and not kept.
 * @param name  of the point, before the axis
 * @param written  a coordinate as its field shows it
 */
export function vectorInput(
    name: string,
    point: Vec3,
    written: (axis: number, value: number) => string,
    changed: (point: Vec3) => void,
): TemplateResult {
    return html`<div class="vector" role="group" aria-label=${name}>
        ${axes.map(
            (axis, k) =>
                html`<input
                    type="number"
                    step="any"
                    aria-label=${`${name} ${axis}`}
                    .value=${written(k, point[k] ?? 0)}
                    @change=${(event: Event) => {
                        const field = event.target as HTMLInputElement;
                        const moved: Vec3 = [...point];
                        moved[k] = field.valueAsNumber;
                        if (Number.isFinite(moved[k])) changed(moved);
                        else field.value = written(k, point[k] ?? 0);
                    }}
                />`,
        )}
    </div>`;
}
