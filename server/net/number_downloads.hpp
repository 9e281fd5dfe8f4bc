// Numbers of a surface over HTTP, as CSV: /api/v1/sessions/S/surfaces/U/numbers.csv?times=0:5:0.1&through=box:0,0,0:1,1,1&fields=p
#pragma once

#include "core/base/memory_account.hpp"
#include "core/surface/measures/region.hpp"
#include "server/base/identity.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/data/series_times.hpp"
#include "server/net/download_request.hpp"
#include "server/net/http_message.hpp"
#include "server/net/shared_files.hpp"
#include "server/sessions/session_directory.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

inline constexpr std::string_view numbers_file = "numbers.csv";
inline constexpr std::size_t most_numbers_times = 500; ///< rows of one file

/// The parameters of a file of numbers.
struct NumbersRequest {
    DownloadRequest shown{};            ///< at which time, if there is one row
    std::optional<SeriesTimes> times{}; ///< one row each
    std::optional<core::Region> through{};
    std::vector<std::string> fields{}; ///< whose means are wanted
};

/// Error: InvalidArgument, naming the fault in the query.
core::Result<NumbersRequest> read_numbers(const std::map<std::string, std::string>& query);

/// Serves numbers. Loop thread only; the pool does the work, as that of meshes.
class NumberDownloads {
  public:
    /// REQUIRES: all arguments outlive this.
    NumberDownloads(const SessionDirectory& sessions,
                    const DatasetCatalogue& catalogue,
                    const core::MemoryAccount& account,
                    SharedFiles& files)
        : sessions_(sessions), catalogue_(catalogue), account_(account), files_(files) {}

    /// Answers a request of a surface's numbers.
    void get(const HttpRequest& request,
             const Identity& identity,
             const std::string& session,
             const std::string& surface,
             const Respond& respond);

  private:
    core::Result<void> offer(const HttpRequest& request,
                             const Identity& identity,
                             const std::string& session,
                             const std::string& surface,
                             const Respond& respond);

    const SessionDirectory& sessions_;
    const DatasetCatalogue& catalogue_;
    const core::MemoryAccount& account_;
    SharedFiles& files_;
};

} // namespace wakesurf::server
