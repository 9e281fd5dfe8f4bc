// What several panels say: the state of the picture, in which what is coarse or old must not pass for the result, moments as people say
// them, and the names of roles.
import type { Role } from '../../protocol/messages.ts';
import type { SurfacePhase } from '../../state/appState.ts';

export const phaseWords: Record<SurfacePhase, string> = {
    waiting: 'Waiting for the server …',
    ended: 'No longer connected',
    gone: 'Not in a session',
    hidden: 'Hidden',
    none: 'Computing the first surface …',
    updating: 'Updating …',
    coarse: 'Coarse, refining …',
    live: 'Playing',
    final: 'Final',
    coarsened: 'Coarser than asked for',
    empty: 'Nothing to see',
    stopped: 'Stopped before it was final',
    error: 'Not computed',
};

export function countWords(count: number): string {
    return count.toLocaleString('en').replaceAll(',', '\u202f');
}

const steps: readonly [seconds: number, unit: Intl.RelativeTimeFormatUnit][] = [
    [31_536_000, 'year'],
    [2_592_000, 'month'],
    [604_800, 'week'],
    [86_400, 'day'],
    [3600, 'hour'],
    [60, 'minute'],
];
const relative = new Intl.RelativeTimeFormat('en', { numeric: 'auto' });

/** Returns words like "2 hours ago". @param time UTC, as text */
export function agoWords(time: string, now = Date.now()): string {
    const seconds = (Date.parse(time) - now) / 1000;
    if (!Number.isFinite(seconds)) return 'at an unknown time';
    const step = steps.find(([length]) => Math.abs(seconds) >= length);
    return step === undefined ? 'just now' : relative.format(Math.trunc(seconds / step[0]), step[1]);
}

/** The day. @param time UTC, as text */
export function dayWords(time: string): string {
    return new Date(time).toLocaleDateString('en', { dateStyle: 'long' });
}

/** To the minute, and the day where it is not today. */
export function momentWords(moment: Date): string {
    const today = moment.toDateString() === new Date().toDateString();
    return moment.toLocaleString([], { ...(today ? {} : { dateStyle: 'medium' }), timeStyle: 'short' });
}

export const roleWords: Record<Role, string> = {
    viewer: 'can look',
    editor: 'can edit',
    host: 'can edit and invite',
};
