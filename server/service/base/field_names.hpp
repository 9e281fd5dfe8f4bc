// Which fields of a dataset can be asked for at the vertices of a surface and at the nodes of its grid, and
// what is said of a name that is none of them: one answer for sessions, files, level sets, points and the
// command line.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Lists what has a value at the nodes of the grid: the stored scalars and families, the velocity for its
/// magnitude, its components and what is derived from its gradient. Each name once, stored ones first.
/// @param stored  the scalars and families; a built-in flow has none
std::vector<std::string> node_field_names(std::vector<std::string> stored,
                                          const std::string& velocity);

/// Lists what surfaces can carry: these, and what is known of their vertices.
std::vector<std::string> vertex_field_names(std::vector<std::string> stored,
                                            const std::string& velocity);

/// "did you mean vorticity? There is p, U, ..."
std::string field_hint(std::string_view name, std::span<const std::string> there);

/// NotFound. @param parameter  which has the name
/// @param of_files  those of the files that the dataset was imported from, of which some may not have been
/// stored
core::Error no_such_field(std::string_view parameter,
                          const std::string& name,
                          std::span<const std::string> there,
                          std::span<const core::FieldInfo> of_files);

} // namespace wakesurf::server
