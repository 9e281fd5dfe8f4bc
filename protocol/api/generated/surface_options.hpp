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
    {"--rake2", "rake2", "text", "Time: the patch lies between the rake and this one", "", false},
    {"--kind", "kind", "text",
     "Stream: of the field frozen at --from; path: particles released at --from; streak: particles "
     "released from --from on; time: a patch of particles released at --from",
     "", true},
    {"--from", "from", "number",
     "Time of release; streak: of the first one; left out: the dataset's first time (the dataset's "
     "unit of time)",
     "", false},
    {"--to", "to", "number",
     "The surface is shown until this time; the integration takes to - from (the dataset's unit of "
     "time)",
     "", false},
    {"--direction", "direction", "text",
     "forward, backward or both: which way in time particles go", "forward", false},
    {"--accuracy", "accuracy", "text",
     "fast, balanced or exact: of the integration, and of how vertices are put in", "balanced",
     false},
    {"--release-until", "releaseUntil", "number",
     "Streak: the release stops here; left out: at --to (the dataset's unit of time)", "", false},
    {"--sweep", "sweep", "point",
     "Time: the patch is the rake swept along this vector (the dataset's unit of length)", "",
     false},
    {"--merge", "merge", "number",
     "Cells smaller than this merge; 0: never (part of the separation; 0 to 0.5)", "0.35", false},
    {"--angle", "angle", "number",
     "Cells that meet at more than this are refined, as far as the separation and --max-quads "
     "allow; 180: never (degrees; above 0, at most 180)",
     "20", false},
    {"--stagnation-speed", "stagnationSpeed", "number",
     "A particle that is slower counts as at rest and ends; 0: only one that does not move at all "
     "(part of the largest speed; 0 to 0.1)",
     "1e-06", false},
    {"--separation", "separation", "number",
     "The longest edge; left out: the dataset's finest spacing (the dataset's unit of length; "
     "above 0)",
     "", false},
};

} // namespace wakesurf::protocol
