// Made by protocol/api/generate from surface.schema.json: do not edit.
// Options of `wakesurf surface` that are parameters of surface.set.
#pragma once

namespace wakesurf::protocol {

struct SurfaceOption {
    const char* option;
    const char* parameter;
    const char* type;  ///< text, number or point
    const char* words; ///< with range and unit
    const char* usual; ///< what holds where it is left out; empty: as the words say
    bool required;
};

inline constexpr SurfaceOption surface_options[]{
    {"--rake2", "rake2", "text", "Time: the patch lies between the rake and this second rake", "",
     false},
    {"--kind", "kind", "text",
     "Stream: streamlines of the field frozen at --from; path: particles released together at "
     "--from; streak: particles released continuously from --from on; time: a patch of particles "
     "released at --from; level: where --field has the value --level, at the time that is shown "
     "between --from and --to",
     "", true},
    {"--from", "from", "number",
     "Where the surface starts: the (first) release; for stream surfaces, the time at which the "
     "field is frozen; if left out, the first time of the data, or the last where --direction is "
     "backward (the dataset's unit of time)",
     "", false},
    {"--to", "to", "number",
     "Where the surface ends: before --from, time runs backward. A stream surface is followed for "
     "--to - --from, and --to need not lie in the data; for the others it must (the dataset's unit "
     "of time)",
     "", false},
    {"--direction", "direction", "text",
     "forward, backward or both: if left out, forward or backward as --from and --to say; it must "
     "not contradict them. both: to the later time --to, and as long before --from, a path surface "
     "as far as there are data; only for stream and path surfaces",
     "", false},
    {"--accuracy", "accuracy", "text",
     "fast, balanced or exact: how accurately particles are traced and vertices inserted",
     "balanced", false},
    {"--interpolation", "interpolation", "text",
     "linear or smooth: of stored velocity. linear: between the nodes of a cell and in time, as "
     "ParaView shows it; smooth: cubic in space and time, for uniform grids only, see `smooth` of "
     "dataset.describe",
     "linear", false},
    {"--refine", "refine", "text",
     "on or off: whether quads are cut, joined and reconnected, and torn at obstacles. off: the "
     "grid that the rake begins with stays as it is, with a column a seed, as in smoke surfaces; "
     "--merge and --angle then count for nothing, and --separation only along the flow. Quads with "
     "a particle that has ended are left out",
     "on", false},
    {"--release-until", "releaseUntil", "number",
     "Streak: time at which the release stops; if left out, --to (the dataset's unit of time)", "",
     false},
    {"--life", "life", "number",
     "Path, streak or time: longest age of a particle: it ends so long after its release; if left "
     "out, it lives as long as the surface (the dataset's unit of time; above 0)",
     "", false},
    {"--sweep", "sweep", "point",
     "Time: the patch is the rake swept along this vector (the dataset's unit of length)", "",
     false},
    {"--field", "field", "text",
     "Level: scalar field of the dataset, or derived from its velocity, of which the surface is a "
     "level set: its magnitude by the velocity's name, `vorticity`, `q_criterion`, `velocity_x` "
     "and the like",
     "", false},
    {"--level", "level", "number",
     "Level: value that the field has on the surface (the field's unit)", "", false},
    {"--merge", "merge", "number",
     "Quads smaller than this are joined; 0: never (part of the separation; 0 to 0.5)", "0.35",
     false},
    {"--angle", "angle", "number",
     "Neighbouring quads at a larger angle are refined, as far as the separation and --max-quads "
     "allow; 180: never (degrees; above 0, at most 180)",
     "20", false},
    {"--stagnation-speed", "stagnationSpeed", "number",
     "A slower particle counts as at rest and ends; 0: only a particle that does not move at all "
     "(part of the largest speed; 0 to 0.1)",
     "1e-06", false},
    {"--separation", "separation", "number",
     "Longest edge allowed; if left out, the dataset's finest spacing (the dataset's unit of "
     "length; above 0)",
     "", false},
};

} // namespace wakesurf::protocol
