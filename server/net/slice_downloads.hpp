// The values on a plane over HTTP: /api/v1/datasets/D/slice.bin?plane=0,0,0:0,0,1&field=p&time=2.5&samples=320, or that minus the field of another
// dataset or time: &minus=E&minusTime=2. Each reader asks at the resolution of its own screen, and takes back what it does not want any more by hanging up.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/plane.hpp"
#include "core/base/result.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/net/http_message.hpp"
#include "server/net/shared_files.hpp"

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
    std::optional<std::string> minus{}; ///< the dataset of what is subtracted
    std::optional<double> minus_time{};
};

/// Error: InvalidArgument, naming the fault in the query.
core::Result<SliceQuery> read_slice_query(const std::map<std::string, std::string>& query);

/// Serves them. Loop thread only; the pool does the work. They are cached apart from other files, which a plane that is dragged would drive
/// out.
class SliceDownloads {
  public:
    /// REQUIRES: all arguments outlive this.
    SliceDownloads(Loop& loop,
                   ComputePool& pool,
                   const DatasetCatalogue& catalogue,
                   const core::MemoryAccount& account)
        : catalogue_(catalogue), account_(account), files_(loop, pool, &account) {}

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
