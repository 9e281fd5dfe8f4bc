// Says in words what the server sends and this page does not understand: both are not of one version, or one
// of them is at fault.

/** Returns what is wrong in something with a name; a check of it has found that. */
export function faultIn(what: string, fault: string): string {
    return fault.startsWith(' ') ? what + fault : `in ${what}, ${fault.replace(/^\./, '')}`;
}

export function unreadableWords(what: string): string {
    return `This page cannot read what the server sent: ${what}. Reload the page.`;
}

/** The answer to a call is not what the method answers. */
export class UnreadableAnswer extends Error {
    /** @param fault of a check, which begins with the path to what is wrong */
    constructor(method: string, fault: string) {
        super(unreadableWords(faultIn(`the answer to ${method}`, fault)));
        this.name = 'UnreadableAnswer';
    }
}
