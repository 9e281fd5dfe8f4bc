// Text and files handed to the user: to the clipboard, where the browser lets a page do that (not over plain HTTP from another machine), or
// as a download.

/** False when it could not be copied. */
export async function copyText(text: string): Promise<boolean> {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false;
    }
}

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
