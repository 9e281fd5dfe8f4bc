// What leads out of the page, in one file of the bundle: it is fetched while the first picture is drawn.
import './animationExport.ts';
import './copyAs.ts';
import './pictureExport.ts';
