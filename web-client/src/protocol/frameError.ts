// Defines what every reader of the binary wire throws: the bytes are not a frame that continues the mesh. The
// cure is always the same: drop the mesh and subscribe again.

export class FrameError extends Error {
    override readonly name = 'FrameError';
}
