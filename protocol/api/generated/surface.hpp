// Made by protocol/api/generate from surface.schema.json: do not edit.
// Surfaces: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "core/surface/surface_parameters.hpp"
#include "protocol/api/checked_json.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// A surface as the session keeps it: its parameters, not its mesh.
struct SurfaceRecord {
    /// its id
    std::string surface;
    /// counts the edits of a record
    std::uint64_t rev = 0;
    /// counts the surfaces that a record has had; only grows
    std::uint32_t epoch = 0;
    /// an id from rake.list: the particles start there
    std::string rake;
    /// the patch lies between the rake and this one
    std::optional<std::string> rake2;
    /// an id from dataset.list
    std::string dataset;
    /// kind, direction, accuracy, to, releaseUntil, sweep, merge, angle, stagnationSpeed, maxQuads,
    /// from, separation
    core::SurfaceParameters parameters;
    /// further attributes of the vertices, in frames and exports: scalar fields of the dataset, its
    /// velocity (the magnitude), `deformation`, `approximated`, `vorticity` (its magnitude),
    /// `q_criterion`
    std::vector<std::string> fields;

    bool operator==(const SurfaceRecord&) const = default;
};

void read(CheckedJson& in, SurfaceRecord& out);

nlohmann::json surface_json(const SurfaceRecord& record);

/// As it is kept: what read() reads.
nlohmann::json kept_json(const SurfaceRecord& record);

/// Parameters of surface.set: Creates a surface, or replaces its record as a whole, and starts
/// building it.
struct SurfaceSetting {
    static constexpr std::string_view method = "surface.set";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// left out: create one
    std::optional<std::string> surface;
    /// an id from rake.list: the particles start there
    std::string rake;
    /// the patch lies between the rake and this one
    std::optional<std::string> rake2;
    /// an id from dataset.list
    std::string dataset;
    /// kind, to, direction, accuracy, releaseUntil, sweep, merge, angle, stagnationSpeed, maxQuads,
    /// separation
    core::SurfaceParameters parameters;
    /// time of release; streak: of the first one; left out: the dataset's first time (the dataset's
    /// unit of time)
    std::optional<double> from;
    /// further attributes of the vertices, in frames and exports: scalar fields of the dataset, its
    /// velocity (the magnitude), `deformation`, `approximated`, `vorticity` (its magnitude),
    /// `q_criterion`
    std::vector<std::string> fields;
    /// true: only if no one has edited the session and there is no such record yet; it counts as no
    /// edit, so undo does not turn it
    bool default_scene = false;
    /// a name for what the user does; edits that follow each other with the same one are one step
    /// of undo
    std::optional<std::string> gesture;
    /// refuse the edit if the record is at another revision
    std::optional<std::uint64_t> if_rev;

    bool operator==(const SurfaceSetting&) const = default;
};

void read(CheckedJson& in, SurfaceSetting& out);

/// What only some kinds take, and what they must have. Error: InvalidArgument, naming the parameter.
core::Result<void> check_kind(const SurfaceSetting& setting);

/// The same, and whether times follow each other; `from` is where the record has it. Error: as check_kind.
core::Result<void> check_rules(const SurfaceSetting& setting);

/// Parameters of surface.delete: Deletes a surface.
struct SurfaceDelete {
    static constexpr std::string_view method = "surface.delete";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from surface.list
    std::string surface;
    /// a name for what the user does; edits that follow each other with the same one are one step
    /// of undo
    std::optional<std::string> gesture;
    /// refuse the edit if the record is at another revision
    std::optional<std::uint64_t> if_rev;

    bool operator==(const SurfaceDelete&) const = default;
};

void read(CheckedJson& in, SurfaceDelete& out);

/// Parameters of surface.stop: Stops computing a surface, for everyone, within 50 ms. What is there
/// of it stays, and its statistics and surface.done say who stopped it; the next edit of it or its
/// rake computes it again.
struct SurfaceStop {
    static constexpr std::string_view method = "surface.stop";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from surface.list
    std::string surface;

    bool operator==(const SurfaceStop&) const = default;
};

void read(CheckedJson& in, SurfaceStop& out);

/// Parameters of surface.list: The surfaces of a session.
struct SurfaceList {
    static constexpr std::string_view method = "surface.list";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;

    bool operator==(const SurfaceList&) const = default;
};

void read(CheckedJson& in, SurfaceList& out);

} // namespace wakesurf::protocol
