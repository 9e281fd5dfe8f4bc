// Where the project is. npm runs everything here from web-client; the address of this module does not
// help, because drag_latency.ts runs from a bundle elsewhere.
import { resolve } from 'node:path';

export const projectRoot = resolve(process.cwd(), '..');
