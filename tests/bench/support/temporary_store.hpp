// A built-in flow written to disk as a store, gone with the object.
#pragma once

#include "store/store_generation.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <memory>
#include <stdexcept>

namespace wakesurf::bench {

class TemporaryStore {
  public:
    /// Throws std::runtime_error if it cannot be written.
    explicit TemporaryStore(const store::GenerateRequest& request) {
        if (const auto made =
                store::generate_store(request, folder(), [](const store::ImportProgress&) {}, {});
            !made)
            throw std::runtime_error(made.error().message);
    }

    const std::filesystem::path& folder() const { return folder_.path(); }

    std::shared_ptr<const store::StoreReader> reader() const {
        const auto manifest = store::read_store_manifest(folder(), core::PosixDisk()).value();
        return store::StoreReader::open(store::store_layout(manifest, folder()),
                                        std::make_shared<core::PosixDisk>())
            .value();
    }

  private:
    tests::TemporaryFolder folder_;
};

} // namespace wakesurf::bench
