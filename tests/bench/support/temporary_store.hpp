// A generated store in a folder of its own, removed with everything in it.
#pragma once

#include "store/store_generation.hpp"
#include "store/store_reader.hpp"

#include <filesystem>
#include <memory>

namespace wakesurf::bench {

class TemporaryStore {
  public:
    /// Makes the store. Throws std::runtime_error if that fails, for example on a full disk.
    explicit TemporaryStore(const store::GenerateRequest& request);
    ~TemporaryStore();
    TemporaryStore(const TemporaryStore&) = delete;
    TemporaryStore& operator=(const TemporaryStore&) = delete;

    const std::filesystem::path& folder() const { return folder_; }

    /// Returns a reader that has read nothing yet.
    std::shared_ptr<const store::StoreReader> reader() const;

    /// Writes the velocities once more, in half precision, beside the others. Returns a reader of those.
    std::shared_ptr<const store::StoreReader> half_reader() const;

  private:
    std::filesystem::path folder_;
};

} // namespace wakesurf::bench
