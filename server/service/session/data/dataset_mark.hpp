// How a dataset is told from others that have its name: by its mesh and its fields, and by its values, of
// which a growing simulation changes none.
#pragma once

#include "protocol/api/session_file.hpp"
#include "server/service/session/data/datasets.hpp"

namespace wakesurf::server {

protocol::DatasetMark mark_of(const OpenDataset& dataset);

} // namespace wakesurf::server
