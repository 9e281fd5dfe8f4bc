// Which of a source's time-steps have the velocity, and the fields that all of these have: programs write the
// first time-step, or some between, without it.
#pragma once

#include "importer/base/source.hpp"

#include <string>
#include <vector>

namespace wakesurf::importer {

struct StepFields {
    std::vector<std::size_t> steps; ///< those with the velocity
    std::size_t described = 0;      ///< the one that the source is described by
    bool none = false;              ///< no time-step has a velocity
    std::vector<core::FieldInfo> fields;
    std::string note; ///< what is left out, and why; may be empty
};

/// Describes the source by the first of `steps` with a velocity, as choose_velocity finds it, and leaves out
/// the others that are known to lack that velocity. All steps stay where none has one, or the choice is not
/// clear. A step that cannot be read stays, and is reported when the import reaches it. Error: as
/// Source::describe_by of the first.
/// @param times  of all time-steps of the source
core::Result<StepFields> settle_fields(Source& source,
                                       const std::vector<std::size_t>& steps,
                                       const std::vector<double>& times,
                                       const std::string& wish);

} // namespace wakesurf::importer
