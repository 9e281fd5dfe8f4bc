// Names the roles on the page.
import type { Role } from '../../protocol/messages.ts';

export const roleWords: Record<Role, string> = {
    viewer: 'can look',
    editor: 'can edit',
    host: 'can edit and invite',
};
