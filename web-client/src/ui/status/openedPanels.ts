// Panels of the status that are opened on demand, in one file of the bundle: they come beside the first picture.
import '../surface/qualityPanel.ts';
import './numbersPanel.ts';
