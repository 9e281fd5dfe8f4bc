// The files that a panel hands to its user, kept instead of downloaded.
import { vi } from 'vitest';

/** Until mocks are put back. */
export function savedFiles(): { name: string; content: Blob }[] {
    const saved: { name: string; content: Blob }[] = [];
    let content: Blob;
    vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => {
        content = blob as Blob;
        return 'blob:saved';
    });
    vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: HTMLAnchorElement) {
        saved.push({ name: this.download, content });
    });
    return saved;
}
