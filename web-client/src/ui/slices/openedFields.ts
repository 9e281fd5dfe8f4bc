// Slices, streamlines and rakes off bodies with their panels, in one file of the bundle: they come beside the first picture.
export { BodyRakes } from '../rake/bodyRakePanel.ts';
export { Lines } from '../lines/linesPanel.ts';
export { Slices } from './slicesPanel.ts';
