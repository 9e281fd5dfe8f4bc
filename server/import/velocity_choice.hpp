// Which arrays of a source are its velocity: one vector, three components, or a momentum and its density.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "server/import/assembly/node_values.hpp"

#include <set>
#include <string>
#include <vector>

namespace wakesurf::server {

struct VelocityChoice {
    FieldParts parts;
    std::string name; ///< for people
    std::string why;
};

/// In this order, of points before cells: a vector called U, velocity or vel (any case); three arrays called u, v, w or the
/// like; a vector whose name speaks of a velocity that is no average; a momentum with its density; the only vector whose
/// name does not tell that it is something else. `wanted` (--fields), where it names any of these, goes before everything.
/// Error: as choose_fields.
core::Result<VelocityChoice> choose_velocity(const std::vector<core::FieldInfo>& fields,
                                             const std::vector<std::string>& wanted);

/// Names of the arrays that choose_velocity takes of `fields` without --fields; of all vectors, where it finds none or several.
std::set<std::string> possible_velocity(const std::vector<core::FieldInfo>& fields);

/// "p (1 component, point), U (3 components, cell)", or "no array that all its parts have".
std::string listed(const std::vector<core::FieldInfo>& fields);

} // namespace wakesurf::server
