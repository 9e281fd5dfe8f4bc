// Made by protocol/api/generate from surface.schema.json: do not edit.
// Surfaces: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "core/surface/surface_parameters.hpp"
#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::protocol {

/// A surface as the session keeps it: its parameters, not its mesh.
struct SurfaceRecord {
    /// id of the surface
    std::string surface;
    /// counts the edits of a record
    std::uint64_t rev = 0;
    /// counts the surfaces that have been built for the record; it never decreases
    std::uint32_t epoch = 0;
    /// an id from rake.list; the particles start from this rake. A level surface takes no more of
    /// it than its place in lists and its colour
    std::string rake;
    /// the patch lies between the rake and this second rake
    std::optional<std::string> rake2;
    /// an id from dataset.list
    std::string dataset;
    /// kind, accuracy, interpolation, refine, to, releaseUntil, life, sweep, field, level, merge,
    /// angle, stagnationSpeed, maxQuads, from, direction, separation
    core::SurfaceParameters parameters;
    /// additional attributes of the vertices, in frames and exports: scalar fields of the dataset,
    /// its velocity (the magnitude), `deformation`, `approximated`, `error`, `vorticity` (its
    /// magnitude), `vorticity_x`, `vorticity_y`, `vorticity_z`, `q_criterion`, `velocity_x`,
    /// `velocity_y`, `velocity_z`, `normal_x`, `normal_y`, `normal_z` (of the surface)
    std::vector<std::string> fields;

    bool operator==(const SurfaceRecord&) const = default;
};

void read(CheckedJson& in, SurfaceRecord& out);

nlohmann::json record_json(const SurfaceRecord& record);

/// Returns it as it is kept: what read() reads.
nlohmann::json kept_json(const SurfaceRecord& record);

/// Holds the parameters of surface.set.
struct SurfaceSetting : InSession {
    static constexpr std::string_view method = "surface.set";

    /// id of the surface to replace; if left out, a new one is created
    std::optional<std::string> surface;
    /// an id from rake.list; the particles start from this rake. A level surface takes no more of
    /// it than its place in lists and its colour
    std::string rake;
    /// the patch lies between the rake and this second rake
    std::optional<std::string> rake2;
    /// an id from dataset.list
    std::string dataset;
    /// kind, to, direction, accuracy, interpolation, refine, releaseUntil, life, sweep, field,
    /// level, merge, angle, stagnationSpeed, maxQuads, separation
    core::SurfaceParameters parameters;
    /// where the surface starts: the (first) release; for stream surfaces, the time at which the
    /// field is frozen; if left out, the first time of the data, or the last where `direction` is
    /// backward (the dataset's unit of time)
    std::optional<double> from;
    /// additional attributes of the vertices, in frames and exports: scalar fields of the dataset,
    /// its velocity (the magnitude), `deformation`, `approximated`, `error`, `vorticity` (its
    /// magnitude), `vorticity_x`, `vorticity_y`, `vorticity_z`, `q_criterion`, `velocity_x`,
    /// `velocity_y`, `velocity_z`, `normal_x`, `normal_y`, `normal_z` (of the surface)
    std::vector<std::string> fields;
    /// true: make the record only if no one has edited the session and it has no such record yet;
    /// this does not count as an edit, and undo does not take it back
    bool default_scene = false;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;
};

/// What only some kinds take, and what they must have. Error: InvalidArgument, naming the parameter.
core::Result<void> check_kind(const SurfaceSetting& setting);

/// The same, and whether times follow each other; `from` is where the record has it. Error: as check_kind.
core::Result<void> check_rules(const SurfaceSetting& setting);

/// The optional numbers that were given, by their names.
std::vector<std::pair<std::string_view, double>>
given_numbers(const core::SurfaceParameters& parameters);

/// Holds the parameters of surface.delete.
struct SurfaceDelete : InSession {
    static constexpr std::string_view method = "surface.delete";

    /// an id from surface.list
    std::string surface;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;
};

/// Holds the parameters of surface.stop.
struct SurfaceStop : InSession {
    static constexpr std::string_view method = "surface.stop";

    /// an id from surface.list
    std::string surface;
};

/// Holds the parameters of surface.list.
struct SurfaceList : InSession {
    static constexpr std::string_view method = "surface.list";
};

void read(CheckedJson& in, SurfaceSetting& out);
void read(CheckedJson& in, SurfaceDelete& out);
void read(CheckedJson& in, SurfaceStop& out);

} // namespace wakesurf::protocol
