// A server without sockets and threads: sessions, methods and outboxes of the product, on a world's time,
// network, disk and randomness. Its destructor is a crash.
#pragma once

#include "server/live/compute/compute_pool.hpp"
#include "server/live/prober.hpp"
#include "server/net/methods/dispatcher.hpp"
#include "server/sessions/people/grants.hpp"
#include "server/sessions/session_directory.hpp"
#include "tests/simulation/disk.hpp"
#include "tests/simulation/link.hpp"
#include "tests/simulation/world.hpp"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

namespace wakesurf::simulation {

/// Reads the disk's content, as a restarted server does.
class WorldServer {
  public:
    WorldServer(World& world, Disk& disk, const server::Datasets& datasets);
    ~WorldServer();
    WorldServer(const WorldServer&) = delete;
    WorldServer& operator=(const WorldServer&) = delete;

    /// Accepts a client.
    void welcome(const std::shared_ptr<Link>& link);

    /// Returns the result of a call by the server's owner that is answered at once.
    nlohmann::json ask(const std::string& method, const nlohmann::json& parameters);

    server::Session& session() { return **sessions_.find("main"); }

  private:
    class Connection;

    /// A clock that advances when a running job reads it.
    class JobClock final : public core::Clock {
      public:
        explicit JobClock(World& world) : world_(world) {}

        Instant now() const override { return world_.now() + (passed_ += each_); }

        void begin() { each_ = Duration(1 + world_.pick(world_.chance(0.1) ? 60'000 : 2'000)); }

        void end() { each_ = passed_ = Duration(0); }

      private:
        World& world_;
        Duration each_{0};
        mutable Duration passed_{0};
    };

    void compute();

    World& world_;
    JobClock clock_;
    WorldLoop loop_;
    WorldEntropy entropy_;
    WorldJournal journal_;
    server::ComputePool pool_{server::ComputePool::ByHand{}};
    server::Prober prober_{loop_, pool_};
    server::Grants grants_;
    server::SessionDirectory sessions_;
    server::Dispatcher dispatcher_;
    bool computing_ = false;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
    std::vector<std::shared_ptr<Connection>> connections_;
};

} // namespace wakesurf::simulation
