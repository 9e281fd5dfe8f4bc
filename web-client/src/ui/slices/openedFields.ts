// Slices and streamlines with their panels, in one file of the bundle: they come beside the first picture.
export { Lines } from '../lines/linesPanel.ts';
export { Slices } from './slicesPanel.ts';
