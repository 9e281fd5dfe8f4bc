// The storage of a browser, for tests that have none.
import { vi } from 'vitest';

class KeptTexts {
    private readonly texts = new Map<string, string>();

    getItem(name: string): string | null {
        return this.texts.get(name) ?? null;
    }

    setItem(name: string, text: string): void {
        this.texts.set(name, text);
    }
}

/** Empty, until the globals are put back. */
export function emptyStorage(...names: ('localStorage' | 'sessionStorage')[]): void {
    for (const name of names) vi.stubGlobal(name, new KeptTexts());
}
