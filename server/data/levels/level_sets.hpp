// The level sets of a dataset's scalar fields. The last field stays loaded in a process that extracts them,
// so that dragging a level costs the extraction alone; the process ends after some idle time, or when its
// memory is needed.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/memory_account.hpp"
#include "core/surface/level/level_source.hpp"
#include "server/data/levels/level_process.hpp"
#include "server/data/levels/node_values.hpp"

#include <chrono>
#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace wakesurf::server {

class LevelSets final : public core::LevelSource {
  public:
    struct Options {
        std::optional<core::MemoryAccount> account{}; ///< empty: not counted
        const core::Clock* clock = nullptr;           ///< outlives this; null: the machine's
        LevelProcess::Options process{};
        /// The fields of the dataset's files, stored or not.
        std::vector<core::FieldInfo> of_files{};
        std::chrono::seconds idle{30}; ///< after which end_idle() ends the process
    };

    /// @param velocity  the name of the dataset's
    /// @param scalars   of the store; null: its present ones
    LevelSets(std::shared_ptr<const core::Flow> flow,
              std::shared_ptr<const store::StoreReader> store,
              std::string velocity,
              Options options,
              std::shared_ptr<const store::StoreScalars> scalars = nullptr);
    ~LevelSets() override;

    core::Result<core::LevelTriangles> extract(const core::LevelWanted& wanted,
                                               const std::stop_token& stop) const override;
    core::Result<void> check_field(const std::string& name) const override;

    /// Releases the process if it is idle; null without one. Destroying the result ends the process, and
    /// waits for that.
    std::shared_ptr<void> take_idle() const;

    /// Returns the process for tests; empty without one, and while it is at work.
    std::optional<pid_t> process() const;

    /// Returns the number of callers at work or waiting, for tests.
    std::size_t asking() const;

  private:
    /// Describes the loaded field.
    struct Loaded {
        core::MemoryAccount::Share share;
        std::optional<LevelMemory> memory;
        std::unique_ptr<LevelProcess> process;
        /// The field whose values are loaded.
        std::optional<NodeField> field;
        double time = 0.0;
        std::uint64_t version = 0; ///< of the values
        bool gaps = false;
        /// The range of the values; empty without values.
        std::optional<std::array<double, 2>> range;
    };

    /// Gives one thread at a time access to what is loaded, in the order of asking.
    class OneAtATime;

    core::Result<core::LevelTriangles>
    extract_in(Loaded& loaded, const core::LevelWanted& wanted, const std::stop_token& stop) const;
    core::Result<void> begin(Loaded& loaded, const std::stop_token& stop) const;
    core::Result<void>
    load(Loaded& loaded, const NodeField& field, double time, const std::stop_token& stop) const;
    core::Result<core::LevelTriangles> placed(const Loaded& loaded, LevelMesh&& mesh) const;
    std::shared_ptr<Loaded> take() const;

    std::shared_ptr<const core::Flow> flow_;
    std::shared_ptr<const store::StoreReader> store_;
    std::shared_ptr<const store::StoreScalars> scalars_;
    std::string velocity_;
    Options options_;
    mutable std::mutex mutex_; ///< guards what follows
    mutable std::condition_variable_any next_;
    mutable std::list<const OneAtATime*>
        turns_;                              ///< in the order of asking; the first one is at work
    mutable std::shared_ptr<Loaded> loaded_; ///< without turns; null: nothing is loaded
    mutable std::chrono::steady_clock::time_point asked_{};
    std::shared_ptr<void> ticket_;
};

} // namespace wakesurf::server
