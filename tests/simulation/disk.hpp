// A server's disk in a world, and the journal on it: writes last a while, in order, sometimes for long;
// writes that are pending when the server crashes are lost.
#pragma once

#include "server/base/journal.hpp"
#include "tests/simulation/world.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::simulation {

/// Stores the records. Outlives the servers.
struct Disk {
    using Key = std::pair<std::string, std::string>; ///< type, id

    void take(const std::string& session, const server::JournalEntry& entry) {
        const Key key{entry.type, entry.id};
        if (entry.record) {
            sessions[session][key] = *entry.record;
        } else {
            sessions[session].erase(key);
            deleted.insert(key);
        }
    }

    std::map<std::string, std::vector<server::JournalEntry>> entries() const {
        std::map<std::string, std::vector<server::JournalEntry>> out;
        for (const auto& [session, records] : sessions)
            for (const auto& [key, record] : records)
                out[session].push_back({key.first, key.second, record});
        return out;
    }

    std::map<std::string, std::map<Key, std::string>> sessions;
    std::set<Key> deleted; ///< at some time
    Instant full_until{};
};

/// The journal of one server's life.
class WorldJournal final : public server::Journal {
  public:
    WorldJournal(World& world, Disk& disk) : world_(world), disk_(disk) {}

    void write(const std::string& session, std::vector<server::JournalEntry> entries) override {
        batches_.push_back([this, session, entries = std::move(entries)] {
            for (const server::JournalEntry& each : entries)
                disk_.take(session, each);
        });
        ++written_;
        work();
    }

    void remove(const std::string& session) override {
        batches_.push_back([this, session] { disk_.sessions.erase(session); });
        ++written_;
        work();
    }

    void settled(std::function<void(core::Result<void>)> done) override {
        waiting_.push_back({written_, std::move(done)});
        work();
    }

    std::optional<core::Error> refusal() const override {
        if (world_.now() >= disk_.full_until)
            return std::nullopt;
        return core::Error{core::Error::Code::Io, "the disk is full", "make room"};
    }

  private:
    struct Waiting {
        std::size_t batches; ///< written before
        std::function<void(core::Result<void>)> done;
    };

    void work() {
        if (std::exchange(busy_, true))
            return;
        world_.after(world_.time_between(Duration(100), Duration(12000)),
                     [this, alive = std::weak_ptr(alive_)] {
                         if (!alive.expired())
                             sync();
                     });
    }

    void sync() {
        busy_ = false;
        const bool full = world_.now() < disk_.full_until;
        for (std::size_t some = full || batches_.empty() ? 0 : 1 + world_.pick(batches_.size());
             some > 0; --some) {
            batches_.front()();
            batches_.pop_front();
        }
        const std::size_t kept = written_ - batches_.size();
        std::deque<Waiting> told;
        while (!waiting_.empty() && (full || waiting_.front().batches <= kept)) {
            told.push_back(std::move(waiting_.front()));
            waiting_.pop_front();
        }
        for (Waiting& each : told) // an error only where something is not kept
            if (each.batches <= kept)
                each.done({});
            else
                each.done(core::fail(core::Error::Code::Io, "the disk is full", "make room"));
        if (!batches_.empty() || !waiting_.empty())
            work();
    }

    World& world_;
    Disk& disk_;
    std::deque<std::function<void()>> batches_;
    std::size_t written_ = 0;
    std::deque<Waiting> waiting_;
    bool busy_ = false;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

} // namespace wakesurf::simulation
