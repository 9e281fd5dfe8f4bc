// The choice of a source's velocity: one vector, three components, or a momentum and its density.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <array>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Reads a field of several arrays of equal length: `components` numbers a tuple.
struct FieldParts {
    /// One array of all components, or one a component; all of points or all of cells.
    std::vector<core::FieldInfo> arrays;
    /// Is empty, or holds one array of 1 component by which the others are divided.
    std::vector<core::FieldInfo> divisor;
    int components = 1;
};

struct VelocityChoice {
    FieldParts parts;
    std::string name; ///< for people
    std::string why;
    /// A note, if the name does not say that this is the fluid's velocity; else empty.
    std::string doubt{};
};

/// The names of three scalars that their file states to be the components x, y and z of one velocity,
/// whatever they are called.
using StatedComponents = std::array<std::string, 3>;

/// Chooses in this order, of points before cells: what the file states (`stated`); a vector called U, velocity or vel (any case); three arrays
/// called u, v, w or the like; a vector whose name leaves no doubt that it is the fluid's velocity; a
/// momentum with its density; a vector whose name speaks of a velocity; the only vector whose name does not
/// say that it is something else, as a grid's velocity does. `wish` (--velocity) goes before everything: one
/// vector, three scalars, or a momentum and its density, with commas between. Error: NotFound (no velocity;
/// the wish is not there), InvalidArgument (several candidates), Unsupported (a momentum without its density;
/// the wish is no velocity), each listing what there is.
core::Result<VelocityChoice> choose_velocity(const std::vector<core::FieldInfo>& fields,
                                             const std::string& wish,
                                             const std::vector<StatedComponents>& stated = {});

/// Returns wishes that choose_velocity would follow, the likeliest first, for a user who has to choose. At
/// most 32.
std::vector<std::string> velocity_candidates(const std::vector<core::FieldInfo>& fields,
                                             const std::vector<StatedComponents>& stated = {});

/// Returns the names of the arrays that choose_velocity takes of `fields`; of all vectors if it finds none or
/// several.
std::set<std::string> possible_velocity(const std::vector<core::FieldInfo>& fields,
                                        const std::string& wish,
                                        const std::vector<StatedComponents>& stated = {});

/// Returns "p (1 component, point), U (3 components, cell)", or "no array that all its parts have".
std::string listed(const std::vector<core::FieldInfo>& fields);

} // namespace wakesurf::importer
