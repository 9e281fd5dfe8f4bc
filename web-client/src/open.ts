// The page's first module, and a small one: the worker is fetched, and connects, while the rest of the page is fetched and parsed. After
// one another they took half a second more (`npm run bench:first`).
import { connect } from './session/connect.ts';
import { readFragment, showFragment, writeFragment } from './session/view/urlState.ts';

const url = readFragment(location.hash);
// The token must not stay in the address bar, in the history or in a link that is passed on.
showFragment(writeFragment(url.session, url.dataset, new URLSearchParams(location.hash.slice(1)).get('state')));
const connected = connect(url);
import('./main.ts').then(
    ({ startPage }) => startPage(connected),
    () => {
        connected.worker.stop();
        document.body.append('The page could not be loaded. Reload it once the server can be reached.');
    },
);
