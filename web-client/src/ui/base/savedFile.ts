// A file that the server has to make first: words and a way out while it is awaited.
import { signal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit';
import { saveFile } from './copyAndSave.ts';

export class SavedFile {
    private readonly under = signal<AbortController | null>(null);

    get isAwaited(): boolean {
        return this.under.value !== null;
    }

    /** @param get returns null where there is none, and why is told */
    async save(name: string, get: (signal: AbortSignal) => Promise<Blob | null>): Promise<void> {
        const under = new AbortController();
        this.under.value = under;
        const file = await get(under.signal);
        if (this.under.value !== under) return;
        this.under.value = null;
        if (file !== null) saveFile(file, name);
    }

    cancel(): void {
        this.under.value?.abort();
        this.under.value = null;
    }

    row(): TemplateResult | typeof nothing {
        if (!this.isAwaited) return nothing;
        return html`<p class="quiet" role="status">
            The server is making the file …
            <button type="button" @click=${() => this.cancel()}>Cancel</button>
        </p>`;
    }
}
