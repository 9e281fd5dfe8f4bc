// Whole meshes over HTTP: a surface as a file for other programs, and a dataset's obstacle for the page.
#pragma once

#include "server/catalogue/dataset_catalogue.hpp"
#include "server/net/http_message.hpp"
#include "server/session/compute_pool.hpp"
#include "server/session/loop.hpp"
#include "server/session/session_directory.hpp"

#include <map>
#include <memory>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Loop thread only; the work is done in the pool.
class Downloads {
  public:
    Downloads(Loop& loop,
              ComputePool& pool,
              const SessionDirectory& sessions,
              const DatasetCatalogue& catalogue);
    ~Downloads();
    Downloads(const Downloads&) = delete;
    Downloads& operator=(const Downloads&) = delete;

    /// A path below /api/v1/. False: no such path.
    bool handle(const HttpRequest& request, const Respond& respond);

  private:
    struct State;

    void surface(const HttpRequest& request,
                 const std::string& session,
                 const std::string& surface,
                 const std::string& file,
                 const Respond& respond);
    void obstacle(const std::string& dataset, const Respond& respond);

    std::shared_ptr<State> state_;
};

} // namespace wakesurf::server
