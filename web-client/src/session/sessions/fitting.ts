// Names of sessions, as long as the server takes them.

const mostBytes = 120;

/** Cut between characters, so that it and what is put behind it fit. */
export function fitting(name: string, end = ''): string {
    const characters = [...name];
    while (new TextEncoder().encode(characters.join('') + end).length > mostBytes) characters.pop();
    return characters.join('') + end;
}
