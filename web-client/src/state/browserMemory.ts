// What this browser keeps between visits: choices of its user, nothing of the flow. Browsers may be told
// to keep nothing.

export function recall(name: string): string | null {
    try {
        return localStorage.getItem(`wakesurf.${name}`);
    } catch {
        return null;
    }
}

export function keep(name: string, value: string): void {
    try {
        localStorage.setItem(`wakesurf.${name}`, value);
    } catch {
        // Then it is as on the first visit the next time.
    }
}
