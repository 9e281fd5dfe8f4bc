// The values on a plane over HTTP: /api/v1/datasets/D/slice.bin?plane=0,0,0:0,0,1&field=p&time=2.5&samples=320. Each reader asks at the
// resolution of its own screen.
#pragma once

#include "core/base/plane.hpp"
#include "core/base/result.hpp"
#include "server/net/field_downloads.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

inline constexpr std::string_view slice_file_name = "slice.bin";

/// The parameters of a slice's values.
struct SliceQuery {
    core::Plane plane{};
    std::string field{}; ///< empty: the velocity
    std::optional<double> time{};
    std::size_t samples = 256;
};

/// Error: InvalidArgument, naming the fault in the query.
core::Result<SliceQuery> read_slice_query(const std::map<std::string, std::string>& query);

/// Plans the raster that a query asks for.
core::Result<FieldFile> plan_slice(const std::map<std::string, std::string>& query,
                                   const FieldSource& source);

} // namespace wakesurf::server
