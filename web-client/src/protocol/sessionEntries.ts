// Sessions as lists of them tell: session.list and what follows from it. Times are UTC, as text.

export interface SessionEntry {
    session: string;
    name: string;
    /** Here now. */
    participants: number;
    /** Who was here; who came last comes first. */
    people: { name: string; colour: string }[];
    /** Missing where the session is older than this was noted. */
    created?: string;
    lastUsed: string;
    /** By anyone, beyond the first rake and surface that a page puts there. */
    edited: boolean;
    rakes: number;
    surfaces: number;
    bookmarks: number;
    annotations: number;
    /** There is a picture of it. */
    thumbnail: boolean;
    /** In the trash since then, and until when it can be restored. */
    deletedAt?: string;
    deletedUntil?: string;
}

export interface SessionList {
    sessions: SessionEntry[];
    /** How many sessions the server keeps, and how many deleted ones. */
    limit: number;
    trashLimit: number;
}

export interface SessionMade {
    session: string;
    name: string;
    /** How many more can be made. */
    remaining: number;
}

/** What came of a file; `notes`, for people, say what of it is not as it was. */
export interface SessionImported extends SessionMade {
    notes: string[];
}
