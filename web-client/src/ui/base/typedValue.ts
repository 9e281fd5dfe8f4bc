// The value of a field that can be typed into: as given, except while something else is being typed there, which a
// render in between must not overwrite. Panels are rendered whenever a surface grows.
import { noChange } from 'lit';
import { Directive, directive, type ElementPart, type PropertyPart } from 'lit/directive.js';

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

export const typedValue = directive(TypedValue);
