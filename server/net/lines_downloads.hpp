// Streamlines over HTTP: /api/v1/datasets/D/lines.bin?from=line:0,0,0:1,0,0&seeds=50&field=p&time=2.5. Each reader asks for the time that it
// shows, and takes back what it does not want any more by hanging up.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/surface/lines/line_seeds.hpp"
#include "core/surface/lines/stream_lines.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/net/http_message.hpp"
#include "server/net/shared_files.hpp"

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

/// Serves them. Loop thread only; the pool does the work. They are cached apart from other files, which a clock that plays would drive out.
class LinesDownloads {
  public:
    /// REQUIRES: all arguments outlive this.
    LinesDownloads(Loop& loop,
                   ComputePool& pool,
                   const DatasetCatalogue& catalogue,
                   const core::MemoryAccount& account)
        : catalogue_(catalogue), account_(account), files_(loop, pool, &account_) {}

    /// Answers a request. @param line  the key for taking turns in the pool
    void get(const HttpRequest& request,
             const std::string& line,
             const std::string& dataset,
             const Respond& respond);

  private:
    core::Result<void> offer(const HttpRequest& request,
                             const std::string& line,
                             const std::string& dataset,
                             const Respond& respond);

    const DatasetCatalogue& catalogue_;
    const core::MemoryAccount& account_;
    SharedFiles files_;
};

} // namespace wakesurf::server
