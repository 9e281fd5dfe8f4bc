// What an animation holds beside its viewer: a description as JSON, and in base64 the frames of all its steps, the first a KEY, and those
// of the body, if there is one. The server writes them into the page (protocol/files/animation_page.hpp).
import type { Lattice } from '../protocol/lattice.ts';

export interface AnimatedValue {
    /** As the frames name it. */
    name: string;
    /** For people, with its unit. */
    title: string;
    /** Over all steps. */
    range: readonly [number, number];
    /** Zero is its middle. */
    signed: boolean;
}

export interface AnimationDescription {
    title: string;
    kind: 'stream' | 'path' | 'streak' | 'time' | 'level';
    /** When the surface begins. */
    from: number;
    bounds: readonly [number, number, number, number, number, number];
    lattice: Lattice;
    /** What the frames carry, in their order. */
    attributes: readonly string[];
    /** What can be shown in colours. */
    values: readonly AnimatedValue[];
    times: readonly number[];
    lengthUnit: string;
    timeUnit: string;
    /** Sentences: how it was made and how exact it is. */
    facts: readonly string[];
    /** As savedLook() made it; whoever wrote it. */
    look?: unknown;
}

export interface AnimationFile {
    description: AnimationDescription;
    /** One binary message of the wire each, in order. */
    frames: Uint8Array[];
}

/** Throws where the file is not whole. */
export function readAnimation(description: string, frames: string): AnimationFile {
    if (description === '' || frames === '') {
        throw new Error('This page holds no animation. wakesurf surface -o FILE.html writes one.');
    }
    return { description: JSON.parse(description) as AnimationDescription, frames: split(bytesOf(frames)) };
}

export function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    return bytes;
}

/** Each frame stands behind its length, as 32 bits. */
function split(bytes: Uint8Array): Uint8Array[] {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const frames: Uint8Array[] = [];
    for (let at = 0; at < bytes.length;) {
        const begin = at + 4;
        at = begin > bytes.length ? Infinity : begin + view.getUint32(begin - 4, true);
        if (at > bytes.length) throw new Error('This file is not whole: it ends within a step.');
        frames.push(bytes.subarray(begin, at));
    }
    return frames;
}
