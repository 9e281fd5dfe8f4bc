// Declares what the worker hands to the scene of the body in the flow.
export interface BodyMesh {
    /** xyz of vertices. */
    positions: Float32Array;
    /** xyz, of length 1; 0 where a vertex has no area round it. */
    normals: Float32Array;
    /** Three a triangle. */
    indices: Uint32Array;
}
