// A cell as numbers: eight ids, corners 0-3, then the mids of sides 0-3, noVertex where there is none. (In
// the server's unsigned numbers that is 0xffffffff.)

export const cellStride = 8;
export const noVertex = -1;
