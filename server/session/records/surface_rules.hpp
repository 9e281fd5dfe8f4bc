// Which surfaces a dataset can give: the checks of surface.set that need no session.
#pragma once

#include "protocol/api/generated/surface.hpp"
#include "server/session/data/datasets.hpp"

namespace wakesurf::server {

/// Fills in what was left to the dataset (the separation) or to `from` and `to` (the direction), and leaves out fields named twice. Error: InvalidArgument (an unknown field; what the kind of
/// surface does not have, or lacks), naming the parameter.
core::Result<void> complete_surface(protocol::SurfaceSetting& setting, const OpenDataset& dataset);

} // namespace wakesurf::server
