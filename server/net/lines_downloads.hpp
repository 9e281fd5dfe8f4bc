// Streamlines over HTTP: /api/v1/datasets/D/lines.bin?from=line:0,0,0:1,0,0&seeds=50&field=p&time=2.5.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/lines/line_seeds.hpp"
#include "core/surface/lines/stream_lines.hpp"
#include "server/net/field_downloads.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

inline constexpr std::string_view lines_file_name = "lines.bin";

/// The parameters of lines.
struct LinesQuery {
    core::LineSeeds seeds{};
    core::Direction direction = core::Direction::Both;
    double duration = 0.0;
    double length = 0.0;
    std::string field{}; ///< empty: the velocity
    std::optional<double> time{};
};

/// Error: InvalidArgument, naming the fault in the query.
core::Result<LinesQuery> read_lines_query(const std::map<std::string, std::string>& query);

/// Plans the lines that a query asks for.
core::Result<FieldFile> plan_lines(const std::map<std::string, std::string>& query,
                                   const FieldSource& source);

} // namespace wakesurf::server
