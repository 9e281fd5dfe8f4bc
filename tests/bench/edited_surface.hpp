// A session on a server of its own with one stream surface and a rake to move back and forth: the set-up of
// benchmarks of edits.
#pragma once

#include "core/base/vec3.hpp"
#include "tests/bench/live_server.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace wakesurf::bench {

class EditedSurface {
  public:
    /// @param quads  the surface settles on about so many, for any dataset
    EditedSurface(const ServerAddress& address, double quads, int seeds = 32);

    LiveClient& client() { return client_; }

    const std::string& session() const { return session_; }

    const std::string& surface() const { return surface_; }

    double quads() const { return quads_; }

    /// Returns the parameters of rake.set that move the rake a little further.
    nlohmann::json next_edit();

    /// Returns the statistics of the surface, once it is complete.
    nlohmann::json complete();

    /// Reads frames up to the first of an epoch after `epoch`; returns its epoch.
    std::uint32_t until_frame_after(std::uint32_t epoch);

  private:
    nlohmann::json rake() const;
    std::string ready_dataset();

    LiveClient client_;
    core::Vec3 low_{0.0}, size_{0.0};
    std::string session_, rake_, surface_;
    int seeds_;
    double quads_ = 0.0;
    double phase_ = 0.0;
};

} // namespace wakesurf::bench
