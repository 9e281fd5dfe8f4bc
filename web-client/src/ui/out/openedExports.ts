// What leads out of the page, in one file of the bundle: it comes beside the first picture.
import './animationExport.ts';
import './copyAs.ts';
import './pictureExport.ts';
