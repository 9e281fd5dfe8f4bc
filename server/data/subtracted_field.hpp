// One dataset minus another: the same field in both, at the places that they share. What would be of no meaning is refused.
#pragma once

#include "server/data/node_fields.hpp"

#include <string>

namespace wakesurf::server {

/// Returns the field of `other` that is subtracted from the one of this name in `from`; the velocity is subtracted from the velocity, whatever
/// they are called. Error: NotFound where there is none; InvalidArgument where the units are known and others; OutOfDomain where they share no
/// place.
core::Result<NodeField> subtracted_field(const std::string& name,
                                         const core::DatasetInfo& from,
                                         const core::DatasetInfo& other,
                                         const store::StoreScalars* scalars_of_other);

} // namespace wakesurf::server
