// Hands a file to the user, as a download of the browser.

export function saveFile(content: Blob, name: string): void {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(content);
    link.download = name;
    link.click();
    // The browser has taken hold of it by then.
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Returns what files of this surface are called: the dataset, and what comes after. */
export function fileName(dataset: string | undefined, rest: string): string {
    const safe = (dataset ?? 'wakesurf').replace(/[^\p{L}\p{N}._-]+/gu, '_').slice(0, 80);
    return `${safe === '' ? 'wakesurf' : safe}-${rest}`;
}
