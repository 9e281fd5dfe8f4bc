// Which surfaces a dataset can give: the checks of surface.set that need no session.
#pragma once

#include "protocol/api/messages_surface.hpp"
#include "server/session/data/datasets.hpp"

namespace wakesurf::server {

/// What only some kinds of surface have, and what they must have. Error: InvalidArgument, naming the parameter.
core::Result<void> check_kind(const protocol::SurfaceSetting& setting);

/// Fills in what was left to the dataset (the separation), and leaves out fields named twice. Error: InvalidArgument (an unknown field; what the kind of
/// surface does not have, or lacks), naming the parameter.
core::Result<void> complete_surface(protocol::SurfaceSetting& setting, const OpenDataset& dataset);

} // namespace wakesurf::server
