// Lays out the timeline: a picture with two native sliders over it, whose middle lies exactly over the time
// they mean.
import { css } from 'lit';

export const timelineStyles = css`
    :host {
        display: block;
        position: relative;
        height: 52px;
        margin: 0 14px;
    }
    /* One more line: what the numbers share. */
    :host([shared]) {
        height: 66px;
    }
    text.shared {
        text-anchor: end;
    }
    .picture {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
        overflow: visible;
        pointer-events: none;
    }
    .line {
        fill: var(--line);
    }
    .shown {
        fill: var(--accent);
        opacity: 0.35;
    }
    .released {
        fill: var(--accent);
        opacity: 0.7;
    }
    .release-end {
        stroke: var(--accent);
        stroke-width: 2;
    }
    .now {
        stroke: var(--text);
        stroke-width: 1.5;
    }
    .other {
        stroke-dasharray: 2 2;
    }
    .hollow {
        fill: none;
        stroke: var(--quiet);
        stroke-width: 1;
    }
    .filled,
    .coming {
        fill: var(--quiet);
    }
    .mark {
        pointer-events: all;
    }
    text {
        fill: var(--quiet);
        font-size: 11px;
        font-variant-numeric: tabular-nums;
        text-anchor: middle;
    }
    /* A slider's handle stops half its width before the end: the sliders are that much longer. */
    input[type='range'] {
        position: absolute;
        left: -7px;
        width: calc(100% + 14px);
        margin: 0;
        background: none;
        appearance: none;
    }
    .now-handle {
        top: 0;
        height: 20px;
    }
    .release-handle {
        top: 16px;
        height: 14px;
        pointer-events: none;
    }
    input::-webkit-slider-thumb {
        appearance: none;
        width: 14px;
        height: 14px;
        border: 0;
        cursor: ew-resize;
    }
    input::-moz-range-thumb {
        width: 14px;
        height: 14px;
        border: 0;
        cursor: ew-resize;
    }
    input:focus-visible {
        outline: none;
    }
    input:focus-visible::-webkit-slider-thumb {
        outline: 3px solid var(--accent);
        outline-offset: 1px;
    }
    input:focus-visible::-moz-range-thumb {
        outline: 3px solid var(--accent);
        outline-offset: 1px;
    }
    .now-handle::-webkit-slider-thumb {
        border: 2px solid var(--ground);
        border-radius: 50%;
        background: var(--text);
    }
    .now-handle::-moz-range-thumb {
        border: 2px solid var(--ground);
        border-radius: 50%;
        background: var(--text);
    }
    .release-handle::-webkit-slider-thumb {
        pointer-events: auto;
        background: var(--accent);
        clip-path: polygon(50% 0, 100% 70%, 100% 100%, 0 100%, 0 70%);
    }
    .release-handle::-moz-range-thumb {
        pointer-events: auto;
        background: var(--accent);
        clip-path: polygon(50% 0, 100% 70%, 100% 100%, 0 100%, 0 70%);
    }
    .release-handle:focus-visible::-webkit-slider-thumb {
        background: var(--text);
        clip-path: none;
    }
    .release-handle:focus-visible::-moz-range-thumb {
        background: var(--text);
        clip-path: none;
    }
`;
