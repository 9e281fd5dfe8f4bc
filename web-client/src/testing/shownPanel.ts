// A panel in happy-dom, and what a person does to it. Names are those that a screen reader would say.
import type { LitElement } from 'lit';

/** The pause in which all that is due has been done: promises, frames and renderings. */
export function rested(): Promise<void> {
    return new Promise((resolve) => setTimeout(resolve));
}

/** The element and all below it, also in shadow trees. */
function* allIn(root: ParentNode): Iterable<HTMLElement> {
    for (const each of root.querySelectorAll<HTMLElement>('*')) {
        yield each;
        if (each.shadowRoot !== null) yield* allIn(each.shadowRoot);
    }
}

function words(element: Element | null | undefined): string {
    return (element?.textContent ?? '').replace(/\s+/g, ' ').trim();
}

function nameOf(element: HTMLElement): string {
    const label = element.getAttribute('aria-label');
    if (label !== null) return label;
    const root = element.getRootNode() as ParentNode;
    const labelled = element.id === '' ? null : root.querySelector(`label[for="${element.id}"]`);
    return words(labelled?.querySelector('span') ?? labelled ?? element.closest('label') ?? element);
}

export class ShownPanel {
    readonly root: ParentNode;

    constructor(root: ParentNode) {
        this.root = root;
    }

    /** Shows a panel, alone. @param tag  of the element, which is defined by the module of the panel */
    static async of(tag: string, model: object): Promise<ShownPanel> {
        const panel = Object.assign(document.createElement(tag) as LitElement, { model });
        document.body.replaceChildren(panel);
        await rested();
        return new ShownPanel(document.body);
    }

    all(selector: string, name?: string | RegExp): HTMLElement[] {
        return [...allIn(this.root)].filter((each) => {
            if (!each.matches(selector) || name === undefined) return each.matches(selector);
            return typeof name === 'string' ? nameOf(each) === name : name.test(nameOf(each));
        });
    }

    /** The only one of these. */
    get<Kind extends HTMLElement = HTMLInputElement>(selector: string, name?: string | RegExp): Kind {
        const [found, ...others] = this.all(selector, name);
        if (found === undefined || others.length > 0) {
            throw new Error(
                `${others.length + (found === undefined ? 0 : 1)} of ${selector} ${String(name ?? '')} in: ${this.text}`,
            );
        }
        return found as Kind;
    }

    within(selector: string): ShownPanel {
        return new ShownPanel(this.get<HTMLElement>(selector));
    }

    /** All that is shown in words. */
    get text(): string {
        const shown = [...allIn(this.root)].filter((each) => each.localName !== 'style' && each.closest('[hidden]') === null);
        const own = ({ childNodes }: Node): string => {
            const texts = [...childNodes].filter(({ nodeType }) => nodeType === Node.TEXT_NODE);
            return texts.map(({ textContent }) => textContent).join('');
        };
        return shown.map(own).join(' ').replace(/\s+/g, ' ');
    }

    async click(selector: string, name?: string | RegExp): Promise<void> {
        const button = this.get(selector, name);
        if (button.matches(':disabled, fieldset:disabled *')) throw new Error(`${nameOf(button)} is disabled`);
        button.click();
        await rested();
    }

    press(name: string | RegExp): Promise<void> {
        return this.click('button', name);
    }

    /** Types into a field, moves a slider, or chooses of a list. */
    async enter(selector: string, name: string | RegExp | undefined, value: string | number): Promise<void> {
        const field = this.get(selector, name);
        field.value = String(value);
        for (const type of ['input', 'change']) field.dispatchEvent(new Event(type, { bubbles: true }));
        await rested();
    }

    async key(selector: string, name: string | undefined, key: string, held: KeyboardEventInit = {}): Promise<void> {
        const event = new KeyboardEvent('keydown', { key, bubbles: true, composed: true, cancelable: true, ...held });
        this.get(selector, name).dispatchEvent(event);
        await rested();
    }
}
