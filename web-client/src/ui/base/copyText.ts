// Text to the clipboard, where the browser lets a page do that: not over plain HTTP from another machine.

/** False when it could not be copied. */
export async function copyText(text: string): Promise<boolean> {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false;
    }
}
