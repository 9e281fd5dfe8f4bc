// Checks of values from the wire, each of which says what is wrong with a value and where. generated/ puts
// them together to shapes, member by member; members that a shape does not name are left to newer servers.
// Functions without side effects are marked, so that the bundle has only the shapes that the page checks.
import { isObject } from './jsonRpc.ts';
import { isVec3, type Vec3 } from './vec3.ts';

/** Returns what is wrong with a value that should be a T, beginning with the path to it; null: nothing. */
export type Check<T> = ((value: unknown) => string | null) & { readonly of?: T };

/** Returns whether a value is what a check asks for. */
export function is<T>(value: unknown, check: Check<T>): value is T {
    return check(value) === null;
}

// @__NO_SIDE_EFFECTS__
function plain<T>(sound: (value: unknown) => boolean, what: string): Check<T> {
    return (value) => (sound(value) ? null : ` is not ${what}`);
}

export const text = plain<string>((value) => typeof value === 'string', 'a text');
export const number = plain<number>(Number.isFinite, 'a finite number');
export const whole = plain<number>(Number.isSafeInteger, 'a whole number');
export const flag = plain<boolean>((value) => typeof value === 'boolean', 'true or false');
export const point = plain<Vec3>(isVec3, 'three finite numbers');
export const token = plain<string | number>((value) => typeof value === 'string' || Number.isFinite(value), 'a text or a number');
export const anyObject = plain<Record<string, unknown>>(isObject, 'an object');

// @__NO_SIDE_EFFECTS__
export function oneOf<const T extends string | number>(values: readonly T[]): Check<T> {
    return plain((value) => values.some((each) => each === value), `one of ${values.join(', ')}`);
}

// @__NO_SIDE_EFFECTS__
export function matching(pattern: RegExp): Check<string> {
    return plain((value) => typeof value === 'string' && pattern.test(value), `written as ${pattern.source}`);
}

/** `length`: exactly so many, which the type of the list says. */
export function list<T>(inner: Check<T>): Check<T[]>;
export function list(inner: Check<unknown>, length: number): Check<never>;
// @__NO_SIDE_EFFECTS__
export function list(inner: Check<unknown>, length?: number): Check<never> {
    return (value) => listFault(value, () => inner, length);
}

/** A list of which each entry has a check of its own. */
// @__NO_SIDE_EFFECTS__
export function tuple<T extends readonly unknown[]>(inner: { [Place in keyof T]: Check<T[Place]> }): Check<T> {
    return (value) => listFault(value, (i) => inner[i]!, inner.length);
}

/** An object of which every member is alike. */
// @__NO_SIDE_EFFECTS__
export function mapOf<T>(inner: Check<T>): Check<Record<string, T>> {
    return (value) => (isObject(value) ? memberFault(value, Object.keys(value), () => inner) : ' is not an object');
}

/** An object that has a whole number for every member of `example`. */
// @__NO_SIDE_EFFECTS__
export function wholeMembers<T extends object>(example: T): Check<{ -readonly [Name in keyof T]: number }> {
    const names = Object.keys(example);
    return (value) => (isObject(value) ? memberFault(value, names, () => whole) : ' is not an object');
}

// @__NO_SIDE_EFFECTS__
export function members<T>(checks: { [Name in keyof T]-?: Check<T[Name]> }): Check<T> {
    const [names, inner] = [Object.keys(checks), Object.values<Check<unknown>>(checks)];
    return (value) => (isObject(value) ? memberFault(value, names, (i) => inner[i]!) : ' is not an object');
}

// @__NO_SIDE_EFFECTS__
export function optional<T>(inner: Check<T>): Check<T | undefined> {
    return (value) => (value === undefined ? null : inner(value));
}

// @__NO_SIDE_EFFECTS__
export function orNull<T>(inner: Check<T>): Check<T | null> {
    return (value) => (value === null ? null : inner(value));
}

/** One of several shapes, which the type of the member says. */
// @__NO_SIDE_EFFECTS__
export function either(inner: readonly Check<unknown>[]): Check<never> {
    return (value) => (inner.some((check) => check(value) === null) ? null : ' is none of what it may be');
}

function listFault(value: unknown, checkOf: (i: number) => Check<unknown>, length?: number): string | null {
    if (!Array.isArray(value)) return ' is not a list';
    if (length !== undefined && value.length !== length) return ` has ${value.length} entries, not ${length}`;
    for (let i = 0; i < value.length; ++i) {
        const fault = checkOf(i)(value[i]);
        if (fault !== null) return `[${i}]${fault}`;
    }
    return null;
}

function memberFault(
    value: Record<string, unknown>,
    names: readonly string[],
    checkOf: (i: number) => Check<unknown>,
): string | null {
    for (let i = 0; i < names.length; ++i) {
        const fault = checkOf(i)(value[names[i]!]);
        if (fault !== null) return `.${names[i]}${fault}`;
    }
    return null;
}
