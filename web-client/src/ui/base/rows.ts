// Rows of a panel: words, and the control behind or before them. What a row shows is what its panel holds, also where an edit is refused;
// but what is being typed is not overwritten by a render in between, since panels are rendered whenever a surface grows. Numbers are read
// as people type them, whatever their language and keyboard.
import { html, noChange, nothing, type TemplateResult } from 'lit';
import { Directive, directive, type ElementPart, type PropertyPart } from 'lit/directive.js';
import { live } from 'lit/directives/live.js';
import type { Vec3 } from '../../protocol/messages.ts';
import { fieldNumber, resolutionOf } from '../../scene/base/numbers.ts';
import { leaveKeys } from './keyboard.ts';

const axes = ['x', 'y', 'z'] as const;

/** What a box needs beside its words: an id, and why it is there. */
export interface CheckOptions {
    id?: string;
    title?: string;
    disabled?: boolean;
}

export function checkRow(
    words: string,
    checked: boolean,
    change: (on: boolean) => void,
    { id, title, disabled = false }: CheckOptions = {},
): TemplateResult {
    return html`<label class="check"
        ><input
            id=${id ?? nothing}
            type="checkbox"
            title=${title ?? nothing}
            .checked=${live(checked)}
            ?disabled=${disabled}
            @change=${(event: Event) => change((event.target as HTMLInputElement).checked)}
        />${words}</label
    >`;
}

export interface SliderRow {
    id: string;
    words: string;
    value: number;
    /** Says the value in words. */
    shown: string;
    low: number;
    high: number;
    step: number;
    change: (value: number) => void;
}

export function sliderRow({ id, words, value, shown, low, high, step, change }: SliderRow): TemplateResult {
    return html`<label class="row" for=${id}><span>${words}</span><span class="value">${shown}</span></label>
        <input
            id=${id}
            type="range"
            min=${low}
            max=${high}
            step=${step}
            .value=${live(String(value))}
            @input=${(event: Event) => change((event.target as HTMLInputElement).valueAsNumber)}
        />`;
}

export interface Choice<Value extends string | number> {
    value: Value;
    words: string;
    disabled?: boolean;
}

export function selectRow<Value extends string | number>(
    id: string,
    words: string,
    choices: readonly Choice<Value>[],
    chosen: Value | ((value: Value) => boolean),
    change: (value: Value) => void,
): TemplateResult {
    const isChosen = typeof chosen === 'function' ? chosen : (value: Value): boolean => value === chosen;
    const changed = (event: Event): void => {
        const select = event.target as HTMLSelectElement;
        const choice = choices[select.selectedIndex];
        leaveKeys(select);
        if (choice !== undefined) change(choice.value);
    };
    return html`<label class="row" for=${id}
        ><span>${words}</span>
        <select id=${id} @change=${changed}>
            ${choices.map(
                (each) =>
                    html`<option value=${each.value} ?disabled=${each.disabled} .selected=${live(isChosen(each.value))}>
                        ${each.words}
                    </option>`,
            )}
        </select></label
    >`;
}

export interface NumberField {
    id?: string;
    /** Names the field where no label does. */
    label?: string;
    title?: string;
    /** Puts it among other numbers, where there is little room. */
    narrow?: boolean;
    min?: number;
    max?: number;
    shown: string;
    disabled?: boolean;
    /** Takes what was typed; `false`: it cannot be, which is said, and what was shown before is put back. */
    change: (value: number) => boolean | void;
}

/** Tells the page, which is around all fields, why what was typed is not taken; null: it is. */
export class NumberTyped extends CustomEvent<string | null> {
    static readonly type = 'number-typed';

    constructor(refusal: string | null) {
        super(NumberTyped.type, { detail: refusal, bubbles: true, composed: true });
    }
}

/** Longer numbers are written smaller where there is little room. */
const roomySigns = 6;

/** A field of text: of fields of numbers, browsers decide what is one, each by its own language. */
export function numberField(field: NumberField): TemplateResult {
    const { id, label, title, narrow = false, min = -Infinity, max = Infinity, shown, disabled = false, change } = field;
    const changed = (event: Event): void => {
        const input = event.target as HTMLInputElement;
        const typed = typedNumber(input.value);
        // What becomes of it is shown by the next rendering.
        input.value = shown;
        if (typed === null) return;
        let refusal: string | null = null;
        if (typeof typed === 'string') refusal = typed;
        else if (typed < min || typed > max || change(typed) === false) {
            const low = Number.isFinite(min) ? ` from ${fieldNumber(min, 0)}` : '';
            const high = Number.isFinite(max) ? ` to ${fieldNumber(max, 0)}` : '';
            refusal = `${fieldNumber(typed, 0)} cannot be${low + high === '' ? '' : `, only numbers${low}${high}`}: it stays at ${shown}.`;
        }
        input.dispatchEvent(new NumberTyped(refusal));
    };
    const size = shown.length > roomySigns ? 'number narrow long' : 'number narrow';
    return html`<input
        id=${id ?? nothing}
        class=${narrow ? size : 'number'}
        inputmode=${min >= 0 ? 'decimal' : nothing}
        autocomplete="off"
        title=${title ?? nothing}
        aria-label=${label ?? nothing}
        .value=${typedValue(shown)}
        ?disabled=${disabled}
        @change=${changed}
    />`;
}

export function numberRow(words: string, field: NumberField & { id: string }): TemplateResult {
    const { title, ...rest } = field;
    return html`<label class="row" for=${field.id} title=${title ?? nothing}><span>${words}</span>${numberField(rest)}</label>`;
}

/** Two numbers, from and to; `change` gets them only when they make a span. */
export function pairRow(
    id: string,
    words: string,
    [low, high]: readonly [number, number],
    change: (pair: [number, number]) => void,
): TemplateResult {
    const field = (part: 'from' | 'to', value: number, paired: (typed: number) => [number, number]): TemplateResult =>
        numberField({
            ...{ id: `${id}-${part}`, label: `${words} ${part}`, narrow: true },
            shown: fieldNumber(value, resolutionOf(low, high)),
            change: (typed) => {
                const pair = paired(typed);
                if (pair[0] <= pair[1]) change(pair);
                return pair[0] <= pair[1];
            },
        });
    return html`<div class="pair" role="group" aria-label=${words}>
        ${field('from', low, (typed) => [typed, high])} <span aria-hidden="true">to</span>
        ${field('to', high, (typed) => [low, typed])}
    </div>`;
}

/**
 * Three fields for a point or a direction.
 * @param name  stands before the axis in the name of each field
 * @param written  writes a coordinate as its field shows it
 * @param changed  `false`: it cannot be, and what was shown before is put back
 */
export function vectorFields(
    name: string,
    point: Vec3,
    written: (axis: number, value: number) => string,
    changed: (point: Vec3) => boolean | void,
): TemplateResult[] {
    return axes.map((axis, k) =>
        numberField({
            ...{ label: `${name} ${axis}`, title: `${name} ${axis}`, narrow: true, shown: written(k, point[k] ?? 0) },
            change: (typed) => {
                const moved: Vec3 = [...point];
                moved[k] = typed;
                return changed(moved);
            },
        }),
    );
}

class TypedValue extends Directive {
    private given: string | null = null;

    override render(value: string): string {
        return value;
    }

    override update(part: PropertyPart | ElementPart, [value]: [string]): unknown {
        const field = part.element as HTMLInputElement;
        const focused = (field.getRootNode() as Document | ShadowRoot).activeElement === field;
        const typing = focused && this.given !== null && field.value !== this.given && field.value !== value;
        if (typing) return noChange;
        this.given = value;
        // Also where the field shows another value than was given last.
        if (field.value !== value) field.value = value;
        return noChange;
    }
}

/** The value of a field that can be typed into: as given, except while something else is being typed there. */
export const typedValue = directive(TypedValue);

const plainNumber = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/**
 * With a comma or a point before the decimals, and spaces between groups of three digits. Returns the number; words say why it
 * is none; null: nothing was typed.
 */
export function typedNumber(text: string): number | string | null {
    const typed = text.trim();
    if (typed === '') return null;
    const closed = typed.replaceAll('\u2212', '-').replace(/(?<=\d)\s(?=\d{3}(?!\d))|(?<=^[+-])\s+|\s+(?=e)|(?<=e)\s+/gi, '');
    const marks = closed.replace(/[^.,]/g, '');
    // With both, or several, nobody can tell thousands from decimals.
    if (marks.length > 1) return `${typed} is not clear: write the number with one comma or point, before its decimals.`;
    const plain = closed.replace(',', '.');
    const value = Number(plain);
    if (!plainNumber.test(plain) || !Number.isFinite(value)) return `${typed} is not a number.`;
    return value;
}
