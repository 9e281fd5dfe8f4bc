// Runs before every file of browser tests (vitest.config.ts): no page may complain, in any test.
import { afterAll, afterEach, expect } from 'vitest';
import { takeComplaints } from './complaints.ts';

function expectNoComplaints(): void {
    expect(takeComplaints(), 'complaints of pages').toEqual([]);
}

// Vitest runs hooks of this kind in reverse: these come after those of the file, which close its pages.
afterEach(expectNoComplaints);
afterAll(expectNoComplaints);
