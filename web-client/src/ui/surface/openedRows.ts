// Rows of the surface's panel that are opened on demand, in one file of the bundle: they come beside the first picture.
import './meshRules.ts';
import './twinPanel.ts';
