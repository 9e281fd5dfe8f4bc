// The level sets of a dataset's scalar fields. The field asked for last stays loaded in a process that extracts them, so that a level that
// is dragged costs its extraction alone; that process ends when no one has asked for a while, or when its memory is needed.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/memory_account.hpp"
#include "core/surface/level/level_source.hpp"
#include "server/service/levels/level_process.hpp"
#include "server/service/levels/node_values.hpp"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace wakesurf::server {

class LevelSets final : public core::LevelSource {
  public:
    struct Options {
        std::optional<core::MemoryAccount> account{}; ///< no one counts without
        const core::Clock* clock = nullptr;           ///< outlives it; the machine's without
        LevelProcess::Options process{};
        std::vector<core::FieldInfo>
            of_files{};                ///< the fields of the dataset's files, stored or not
        std::chrono::seconds idle{30}; ///< after which end_idle() ends the process
    };

    /// @param velocity  the name of the dataset's
    /// @param scalars   of the store; null: those that it has now
    LevelSets(std::shared_ptr<const core::Flow> flow,
              std::shared_ptr<const store::StoreReader> store,
              std::string velocity,
              Options options,
              std::shared_ptr<const store::StoreScalars> scalars = nullptr);
    ~LevelSets() override;

    core::Result<core::LevelTriangles> extract(const core::LevelWanted& wanted,
                                               const std::stop_token& stop) const override;
    core::Result<void> check_field(const std::string& name) const override;

    /// What a process that no one has asked for a while holds; null: there is none. Ended where that is freed, which waits for it.
    std::shared_ptr<void> take_idle() const;

    /// Of the process, for tests; nothing while there is none.
    std::optional<pid_t> process() const;

  private:
    /// What is loaded.
    struct Loaded {
        core::MemoryAccount::Share share;
        std::optional<LevelMemory> memory;
        std::unique_ptr<LevelProcess> process;
        std::optional<NodeField> field; ///< whose values are there
        double time = 0.0;
        std::uint64_t version = 0; ///< of the values
        bool gaps = false;
        std::optional<std::array<double, 2>> range; ///< nothing: no values
    };

    /// One thread at a time has what is loaded.
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
    mutable std::condition_variable free_;
    mutable bool busy_ = false;
    mutable std::shared_ptr<Loaded> loaded_; ///< while not busy; null: nothing is
    mutable std::chrono::steady_clock::time_point asked_{};
    std::shared_ptr<void> ticket_;
};

} // namespace wakesurf::server
