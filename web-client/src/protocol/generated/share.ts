// Made by protocol/api/generate from share.schema.json: do not edit.
import { members, number, oneOf, optional, text, whole } from '../checks.ts';
import { roleCheck, type Role } from './shared.ts';

/** a role less than host */
export const newcomerRoles = ['viewer', 'editor'] as const;
export type NewcomerRole = (typeof newcomerRoles)[number];
export const newcomerRoleCheck = oneOf(newcomerRoles);

/** The one who made a link. */
export interface ShareMaker {
    /** the link its maker came by; left out: the server's own token */
    grant?: string;
    /** of the participant; empty: a script */
    name: string;
}

export const shareMakerCheck = members<ShareMaker>({ grant: optional(text), name: text });

/** A share link in force, without its key. */
export interface Share {
    /** its id */
    grant: string;
    /** what someone may do: each role includes the one before */
    role: Role;
    /** left out: never (s since 1970) */
    expires?: number;
    /** where a host gave someone who came by it a lesser role: what those are who come by it from then on */
    newcomers?: NewcomerRole;
    /** who made it */
    madeBy: ShareMaker;
    /** links in force that were made by it, or by those it made */
    children: number;
}

export const shareCheck = members<Share>({
    grant: text,
    role: roleCheck,
    expires: optional(number),
    newcomers: optional(newcomerRoleCheck),
    madeBy: shareMakerCheck,
    children: whole,
});

/** Parameters of session.share. */
export interface SessionShareParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** viewers look, editors edit, hosts also say who may be here */
    role: Role;
    /** from now; left out: 7 days, or as long as the link you came by; null: until it is taken back (s) */
    expiresIn?: number | null;
}

/** What session.share answers. */
export interface SessionShareResult {
    /** its id */
    grant: string;
    /** what someone may do: each role includes the one before */
    role: Role;
    /** left out: never (s since 1970) */
    expires?: number;
    /** where a host gave someone who came by it a lesser role: what those are who come by it from then on */
    newcomers?: NewcomerRole;
    /** who made it */
    madeBy: ShareMaker;
    /** links in force that were made by it, or by those it made */
    children: number;
    /** the secret of the link */
    key: string;
    /** goes behind the page's address */
    link: string;
}

/** Parameters of session.shares. */
export interface SessionSharesParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What session.shares answers. */
export interface SessionSharesResult {
    /** all of them */
    shares: Share[];
}

/** Parameters of session.unshare. */
export interface SessionUnshareParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from session.shares */
    grant: string;
    /** also those made by it, and by those it made */
    children?: boolean;
}

/** What session.unshare answers. */
export interface SessionUnshareResult {
    /** the links made by it that are still in force */
    children: Share[];
}

/** Parameters of session.setRole. */
export interface SessionSetRoleParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from session.state */
    participant: string;
    /** viewers look, editors edit, hosts also say who may be here */
    role: Role;
}

/** What session.setRole answers. */
export interface SessionSetRoleResult {
    /** their id */
    participant: string;
    /** what someone may do: each role includes the one before */
    role: Role;
    /** other places of that person, which get the role too */
    also: string[];
    /** the role of the people who come by that link from now on */
    newcomers?: NewcomerRole;
}

/** Parameters of session.kick. */
export interface SessionKickParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from session.state */
    participant: string;
}
