// Unanswered calls of dataset.open, which wait until a dataset is imported. The last one that is cancelled
// ends the import.
#pragma once

#include "server/base/loop.hpp"
#include "server/data/dataset_catalogue.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Loop thread only.
class ImportWaiters {
  public:
    using Waiter = std::function<void(const core::Result<DatasetStatus>&)>;

    enum class Leaving { Alone, AndStop };

    /// Both outlive this.
    ImportWaiters(DatasetCatalogue& catalogue, Loop& loop) : catalogue_(catalogue), loop_(loop) {}

    ImportWaiters(const ImportWaiters&) = delete;
    ImportWaiters& operator=(const ImportWaiters&) = delete;

    /// Returns how a dataset stands. Error: NotFound.
    core::Result<DatasetStatus> status(const std::string& dataset) const {
        return catalogue_.status(dataset);
    }

    /// Does as the catalogue does.
    core::Result<void> choose_velocity(const std::string& dataset, const std::string& velocity) {
        return catalogue_.choose_velocity(dataset, velocity);
    }

    /// Calls the waiter once the import is ready, has failed or was stopped, at once if it is ready or has
    /// failed already, or after `patience` with how it stands then: at once without any. An import that was
    /// stopped begins again. Returns a ticket for leave(); 0 once the waiter has been called. Error, by the
    /// waiter: NotFound, OverLimit.
    std::uint64_t
    wait(const std::string& dataset, std::chrono::milliseconds patience, Waiter waiter);

    /// Lets go of a waiter without calling it. AndStop: when no call waits any more, the import ends.
    void leave(std::uint64_t ticket, Leaving how);

    /// The dataset's status is another.
    void changed(const std::string& dataset);

  private:
    struct Waiting {
        std::uint64_t id;
        std::string dataset;
        Waiter waiter;
        std::shared_ptr<void> timer;
    };

    void answer(std::uint64_t id);

    DatasetCatalogue& catalogue_;
    Loop& loop_;
    std::vector<Waiting> waiting_;
    std::uint64_t next_ = 1;
};

} // namespace wakesurf::server
