// How this page looks at the session: not shared with others but by a link, a bookmark or following.
// Written by ui/ and session/, read by both.
import { type BodyLook, plainBody } from './bodyLook.ts';
import { signal } from '@preact/signals-core';
import type { Vec3 } from '../protocol/messages.ts';
import { type AutomaticRanges, type SurfaceLook, usualLook } from './surfaceLook.ts';
import { allShown, type ClipPlanes, noClip, type Visibility } from './pageView.ts';
import { noUnits, type Units } from './appState.ts';
import { type LineLook, plainLines } from './lineLook.ts';
import { plainSlices, type SliceLook } from './sliceLook.ts';

/** What a click on the picture does. */
export type Tool = 'none' | 'place' | 'probe' | 'measure' | 'annotate' | 'paint' | 'slice' | 'bodyRake';

export type Theme = 'system' | 'dark' | 'light';

/** What is plotted below the picture: values along the active rake or along the measured line at the time of the picture, over time where the
 *  probe is held, or numbers of the active surface over its time. */
export type PlotOf = 'rake' | 'line' | 'point' | 'surface';

/** What the probe has found. */
export interface ProbeReading {
    point: Vec3;
    /** Simulation time. */
    time: number;
    /** Not in the domain, or in the body: there is nothing. */
    inside: boolean;
    values: { name: string; value: number | Vec3 | null }[];
    /** On which surface; null: on none. */
    on: SeenPlace | null;
}

/** A place on a surface, as it is drawn. */
export interface SeenPlace {
    surface: string;
    s: number;
    t: number;
    /** What the surface is coloured by. */
    scalar: number;
}

/** A note that is being written. */
export interface NoteDraft {
    /** Null: a new one. */
    annotation: string | null;
    text: string;
    position: Vec3;
    surface: string | null;
}

/** What the tool `paint` does to the surface under the pointer. */
export interface Brush {
    does: 'reveal' | 'erase' | 'hidePart';
    radiusPx: number;
}

/** The id of a slice or of streamlines, or bodyId; newSlice, newLines and newBodyRake: one is about to be added. */
export type ChosenThing = string;
export const newSlice = 'new slice';
export const newLines = 'new streamlines';
export const newBodyRake = 'new rake on a body';

export class ViewState {
    readonly tool = signal<Tool>('none');
    readonly theme = signal<Theme>('system');
    /** The units of lengths and of times, as people of the session say, or else the data. Empty:
     *  unknown. */
    readonly units = signal<Units>(noUnits);
    readonly orthographic = signal(false);
    /** Whether what can be seen through is drawn in its exact order once the picture stands still. */
    readonly exactWhenStill = signal(false);
    /** There is shade where things are near each other, once the picture stands still, and in figures. */
    readonly contactShade = signal(true);
    readonly probe = signal<ProbeReading | null>(null);
    /** Where the probe is by now: the newest place, ahead of the reading while that is awaited. */
    readonly probePlace = signal<Vec3 | null>(null);
    /** Where the probe was put last by a click or by numbers, and stays. */
    readonly probeHeld = signal<Vec3 | null>(null);
    /** Null: nothing is plotted. */
    readonly plot = signal<PlotOf | null>(null);
    /** What the pointer is at in the plot. */
    readonly plotPlace = signal<Vec3 | null>(null);
    /** The pointer of the probe is where nothing can be seen. */
    readonly probeMissed = signal(false);
    /** What a tool says beside the pointer, in pixels of the canvas. */
    readonly besidePointer = signal<{ at: { x: number; y: number }; words: string } | null>(null);
    /** Up to two points. */
    readonly measured = signal<readonly Vec3[]>([]);
    /** Of a slice that is to go through three, those that were clicked. */
    readonly slicePoints = signal<readonly Vec3[]>([]);
    /** Of a rake that is drawn on a body, what was clicked and where it goes. */
    readonly bodyWay = signal<{ clicked: readonly Vec3[]; way: readonly Vec3[] }>({ clicked: [], way: [] });
    readonly note = signal<NoteDraft | null>(null);
    /** What was typed into notes and not saved, by note; '' is a new one. */
    private readonly typedNotes = new Map<string, string>();
    readonly panelFolded = signal(false);
    /** By surface; those that are not in it look as usual. */
    readonly looks = signal<ReadonlyMap<string, SurfaceLook>>(new Map());
    /** What colours stand for while a film is made, by what they show; null: as the surfaces' values
     *  are. */
    readonly fixedRanges = signal<AutomaticRanges | null>(null);
    /** What the surfaces of the other half of a comparison range over, which has the same colours. */
    readonly rangesBeside = signal<AutomaticRanges>(new Map());
    readonly visibility = signal<Visibility>(allShown);
    /** What of the list of what is in the picture is chosen; null: the rake and the surface that the panel acts on. */
    readonly chosenThing = signal<ChosenThing | null>(null);
    readonly clip = signal<ClipPlanes>(noClip);
    readonly body = signal<BodyLook>(plainBody);
    readonly slices = signal<SliceLook>(plainSlices);
    readonly lines = signal<LineLook>(plainLines);
    /** The size of a unit of length where the camera looks, once it rests. */
    readonly pixelsPerLength = signal(1);
    /** The parts of the selected surface are listed. */
    readonly partsListed = signal(false);
    /** Surfaces whose painting is too intricate for links and bookmarks. */
    readonly paintLeftOut = signal<ReadonlySet<string>>(new Set());
    readonly brush = signal<Brush>({ does: 'reveal', radiusPx: 24 });
    /** Where the tour is; null: there is none. */
    readonly tourStep = signal<number | null>(null);
    /** The list of sessions lies over the page. */
    readonly sessionsShown = signal(false);
    /** The participant whose view this page takes. */
    readonly following = signal<string | null>(null);

    lookOf(surface: string | null): SurfaceLook {
        return this.looks.value.get(surface ?? '') ?? usualLook;
    }

    /** Asks for the words of a note, or goes on with those that were typed before. */
    writeNote(note: NoteDraft): void {
        this.note.value = { ...note, text: this.typedNotes.get(note.annotation ?? '') ?? note.text };
    }

    /** @param typed what to go on with next time; null: the note is saved, or no longer wanted */
    endNote(typed: string | null): void {
        const about = this.note.value?.annotation ?? '';
        if (typed === null || typed.trim() === '') this.typedNotes.delete(about);
        else this.typedNotes.set(about, typed);
        this.note.value = null;
    }

    changeVisibility(change: Partial<Visibility>): void {
        this.visibility.value = { ...this.visibility.value, ...change };
    }

    changeLook(surface: string, change: Partial<SurfaceLook>): void {
        this.looks.value = new Map(this.looks.value).set(surface, { ...this.lookOf(surface), ...change });
    }
}
