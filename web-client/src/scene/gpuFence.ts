// Tells when the GPU has finished what was drawn so far. Submitting a frame returns at once, so a
// latency taken without this would leave out the drawing itself.

/**
 * Calls back with performance.now() at the moment all commands up to now are done, or with null when they
 * never will be: the context is lost.
 */
export function whenDrawn(gl: WebGL2RenderingContext, done: (time: number | null) => void): void {
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (fence === null) {
        done(null);
        return;
    }
    gl.flush();
    const poll = (): void => {
        const status = gl.isContextLost() ? gl.WAIT_FAILED : gl.clientWaitSync(fence, 0, 0);
        if (status === gl.TIMEOUT_EXPIRED) {
            setTimeout(poll, 1);
            return;
        }
        gl.deleteSync(fence);
        done(status === gl.WAIT_FAILED ? null : performance.now());
    };
    poll();
}
