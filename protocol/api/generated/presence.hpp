// Made by protocol/api/generate from presence.schema.json: do not edit.
// Presence: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "core/base/vec3.hpp"
#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/base/nullable.hpp"
#include "protocol/api/generated/shared.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Where someone looks from.
struct CameraPose {
    /// position of the eye (the dataset's unit of length)
    core::Vec3 position{0.0};
    /// the point in the middle of the picture (the dataset's unit of length)
    core::Vec3 target{0.0};
    /// direction that points up in the picture (the dataset's unit of length)
    core::Vec3 up{0.0};
    /// field of view from top to bottom; if left out, the view is orthographic or unknown (degrees)
    std::optional<double> fov;

    bool operator==(const CameraPose&) const = default;
};

/// A rake while it is dragged.
struct DraggedRake {
    /// id of the rake
    std::string rake;
    /// where the rake is now
    std::vector<core::Vec3> points;

    bool operator==(const DraggedRake&) const = default;
};

/// Holds the parameters of presence.update.
struct PresenceUpdate : InSession {
    static constexpr std::string_view method = "presence.update";

    /// the point they point at (the dataset's unit of length)
    Nullable<core::Vec3> pointer;
    /// where they look from
    Nullable<CameraPose> camera;
    /// the rake they drag
    Nullable<DraggedRake> dragging;
    /// id of the record they have selected
    Nullable<std::string> selected;
};

void read(CheckedJson& in, CameraPose& out);
void read(CheckedJson& in, DraggedRake& out);
void read(CheckedJson& in, PresenceUpdate& out);

nlohmann::json camera_json(const CameraPose& record);
nlohmann::json dragged_rake_json(const DraggedRake& record);

} // namespace wakesurf::protocol
