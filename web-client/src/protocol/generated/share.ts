// Made by protocol/api/generate from share.schema.json: do not edit.
import { members, number, oneOf, optional, text, whole } from '../checks.ts';
import { type InSession, type Role, roleCheck } from './shared.ts';

/** a role below host */
export const newcomerRoles = ['viewer', 'editor'] as const;
export type NewcomerRole = (typeof newcomerRoles)[number];
export const newcomerRoleCheck = oneOf(newcomerRoles);

/** Who made a link. */
export interface ShareMaker {
    /** id of the link by which they came; if left out, they had the server's own token */
    grant?: string;
    /** name of the participant; empty: a script */
    name: string;
}

export const shareMakerCheck = members<ShareMaker>({ grant: optional(text), name: text });

/** A valid share link, without its key. */
export interface Share {
    /** id of the link */
    grant: string;
    /** role of those who come by it */
    role: Role;
    /** when the link expires; if left out, never (s since 1970) */
    expires?: number;
    /** role of those who come by it from now on; present if a host has given someone who came by it a lower role */
    newcomers?: NewcomerRole;
    /** who made it */
    madeBy: ShareMaker;
    /** for a link into a copy that session.fork has made: id of the copy */
    copy?: string;
    /** number of valid links that were made through this one, directly or indirectly */
    children: number;
}

export const shareCheck = members<Share>({
    grant: text,
    role: roleCheck,
    expires: optional(number),
    newcomers: optional(newcomerRoleCheck),
    madeBy: shareMakerCheck,
    copy: optional(text),
    children: whole,
});

/** Parameters of session.share. */
export interface SessionShareParams extends InSession {
    /** viewers look, editors edit, hosts also decide who may be here */
    role: Role;
    /**
     * how long the link is valid; if left out, 7 days, or as long as the link you came by; null: until it is revoked
     * (s)
     */
    expiresIn?: number | null;
}

/** What session.share answers. */
export interface SessionShareResult {
    /** id of the link */
    grant: string;
    /** role of those who come by it */
    role: Role;
    /** when the link expires; if left out, never (s since 1970) */
    expires?: number;
    /** role of those who come by it from now on; present if a host has given someone who came by it a lower role */
    newcomers?: NewcomerRole;
    /** who made it */
    madeBy: ShareMaker;
    /** for a link into a copy that session.fork has made: id of the copy */
    copy?: string;
    /** number of valid links that were made through this one, directly or indirectly */
    children: number;
    /** secret key of the link */
    key: string;
    /** what to append to the address of the page */
    link: string;
}

/** Parameters of session.shares. */
export type SessionSharesParams = InSession;

/** What session.shares answers. */
export interface SessionSharesResult {
    /** all valid links */
    shares: Share[];
}

/** Parameters of session.unshare. */
export interface SessionUnshareParams extends InSession {
    /** an id from session.shares */
    grant: string;
    /** true: also revoke the links that were made through it, directly or indirectly */
    children?: boolean;
}

/** What session.unshare answers. */
export interface SessionUnshareResult {
    /** links made through it that are still valid */
    children: Share[];
}

/** Parameters of session.setRole. */
export interface SessionSetRoleParams extends InSession {
    /** an id from session.state */
    participant: string;
    /** viewers look, editors edit, hosts also decide who may be here */
    role: Role;
}

/** What session.setRole answers. */
export interface SessionSetRoleResult {
    /** id of the participant */
    participant: string;
    /** the role they have now */
    role: Role;
    /** ids of the same person's other places, which get the role too */
    also: string[];
    /** role of those who come by that link from now on */
    newcomers?: NewcomerRole;
}

/** Parameters of session.kick. */
export interface SessionKickParams extends InSession {
    /** an id from session.state */
    participant: string;
}
