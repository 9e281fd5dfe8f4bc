// Made by protocol/api/generate from family.schema.json: do not edit.
// Families of stream surfaces: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/api/base/checked_json.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Holds the parameters of family.make.
struct FamilyMake {
    static constexpr std::string_view method = "family.make";

    /// an id from dataset.list
    std::string dataset;
    /// name of the field, which no other field may have: letters, digits, and _ - .
    std::string name;
    /// where the scalar is given; inflow: on the boundary through which the flow enters; plane: on
    /// a plane; curve: it is the distance from a curve, in the plane of the curve, so that the
    /// level 0 is the stream surface through the curve
    std::string from;
    /// of inflow and plane: x, y or z, or a scalar field of the dataset; empty: y
    std::string scalar;
    /// of a plane: a point of it (the dataset's unit of length)
    std::optional<core::Vec3> point;
    /// of a plane: its normal, of any length; the plane counts where the flow passes it the way
    /// that most of it does (the dataset's unit of length)
    std::optional<core::Vec3> normal;
    /// of a curve: what the points are, as of a rake: a line, a polyline in one plane, or a circle
    std::optional<core::Rake::Kind> rake_kind;
    /// of a curve: its points; the ends of a line or a polyline are continued straight
    std::optional<std::vector<core::Vec3>> points;
    /// the nearest time-step is taken; if left out, the first one (the dataset's unit of time)
    std::optional<double> time;
    /// how accurately particles are traced and vertices inserted
    core::Accuracy accuracy;
    /// how far a node is followed at most; if left out, ten diagonals of the domain (the dataset's
    /// unit of length)
    std::optional<double> length;
    /// on a WebSocket: $/progress reports the progress of the work with this token
    std::optional<std::string> work_done_token;
};

/// Holds the parameters of family.remove.
struct FamilyRemove {
    static constexpr std::string_view method = "family.remove";

    /// an id from dataset.list
    std::string dataset;
    /// name of the field: letters, digits, and _ - .
    std::string name;
};

void read(CheckedJson& in, FamilyMake& out);
void read(CheckedJson& in, FamilyRemove& out);

} // namespace wakesurf::protocol
