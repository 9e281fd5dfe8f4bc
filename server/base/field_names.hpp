// The names of a dataset's fields at the vertices of a surface and at the nodes of its grid, and the error
// for any other name: one answer for sessions, files, level sets, points and the command line.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Lists the fields at the nodes of the grid: the stored scalars and families, the velocity for its
/// magnitude, its components and what is derived from its gradient. Each name once, stored ones first.
/// @param stored  the scalars and families; a built-in flow has none
std::vector<std::string> node_field_names(std::vector<std::string> stored,
                                          const std::string& velocity);

/// Says whether surfaces that move can have an error between stored times.
bool has_interval_errors(const core::DatasetInfo& info);

/// Lists the fields of surfaces: these, and those known only at their vertices.
std::vector<std::string> vertex_field_names(std::vector<std::string> stored,
                                            const core::DatasetInfo& info);

/// Says whether a new field of that name would hide another, or be hidden by it.
/// @param fields  some of the dataset's
bool is_taken(std::string_view name,
              std::string_view velocity,
              std::span<const core::FieldInfo> fields);

/// Returns "did you mean vorticity? There is p, U, ..."
std::string field_hint(std::string_view name, std::span<const std::string> there);

/// Returns a NotFound. @param parameter  which has the name
/// @param of_files  those of the files that the dataset was imported from, some of which may not have been
/// stored
core::Error no_such_field(std::string_view parameter,
                          const std::string& name,
                          std::span<const std::string> there,
                          std::span<const core::FieldInfo> of_files);

} // namespace wakesurf::server
