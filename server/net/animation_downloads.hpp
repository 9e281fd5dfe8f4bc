// A surface in motion over HTTP, as one page: /api/v1/sessions/S/surfaces/U/animation.html?times=0:5:0.1&look={"map":"inferno"}
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "server/base/identity.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/data/series_times.hpp"
#include "server/net/http_message.hpp"
#include "server/net/shared_files.hpp"
#include "server/sessions/session_directory.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace wakesurf::server {

inline constexpr std::string_view animation_file = "animation.html";

/// The parameters of an animation.
struct AnimationRequest {
    std::optional<SeriesTimes> times{}; ///< else evenly from `from` to `to`
    std::string look{};                 ///< as protocol::read_look returned it
};

/// Error: InvalidArgument, naming the fault in the query.
core::Result<AnimationRequest> read_animation(const std::map<std::string, std::string>& query);

/// Serves animations. Loop thread only; the pool does the work, as that of meshes.
class AnimationDownloads {
  public:
    /// REQUIRES: all arguments but the last outlive this. @param viewer  the page without data; null: there is none
    AnimationDownloads(const SessionDirectory& sessions,
                       const DatasetCatalogue& catalogue,
                       const core::MemoryAccount& account,
                       SharedFiles& files,
                       File viewer)
        : sessions_(sessions), catalogue_(catalogue), account_(account), files_(files),
          viewer_(std::move(viewer)) {}

    /// Answers a request of a surface's animation.
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
    File viewer_;
};

} // namespace wakesurf::server
