// Lets files outside web-client (the browser tests) import the packages installed here.
import { fileURLToPath } from 'node:url';

const webClientEntry = fileURLToPath(new URL('../index.html', import.meta.url));

/**
 * @param {string} folder absolute path of the importing files
 * @returns {import('vite').Plugin}
 */
export function resolveFromWebClient(folder) {
    return {
        name: 'resolve-from-web-client',
        enforce: 'pre',
        async resolveId(source, importer, options) {
            const bare = /^[@a-z]/i.test(source) && !source.startsWith('node:');
            if (!bare || importer === undefined || !importer.startsWith(folder)) return null;
            return this.resolve(source, webClientEntry, { ...options, skipSelf: true });
        },
    };
}
