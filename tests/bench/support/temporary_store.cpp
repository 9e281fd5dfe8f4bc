#include "tests/bench/support/temporary_store.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/half.hpp"
#include "store/store_manifest.hpp"

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace wakesurf::bench {

namespace fs = std::filesystem;

namespace {

template <class T>
T or_throw(core::Result<T> result) {
    if (!result)
        throw std::runtime_error(result.error().message);
    return std::move(*result);
}

store::StoreLayout layout_in(const fs::path& folder) {
    return store::store_layout(or_throw(store::read_store_manifest(folder, core::PosixDisk())),
                               folder);
}

std::shared_ptr<const store::StoreReader> open(store::StoreLayout layout) {
    return or_throw(
        store::StoreReader::open(std::move(layout), std::make_shared<core::PosixDisk>()));
}

} // namespace

TemporaryStore::TemporaryStore(const store::GenerateRequest& request) {
    std::string name = (fs::temp_directory_path() / "wakesurf-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("cannot make a temporary folder");
    folder_ = name;
    if (const auto made =
            store::generate_store(request, folder_, [](const store::ImportProgress&) {}, {});
        !made) {
        fs::remove_all(folder_);
        throw std::runtime_error(made.error().message);
    }
}

TemporaryStore::~TemporaryStore() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

std::shared_ptr<const store::StoreReader> TemporaryStore::reader() const {
    return open(layout_in(folder_));
}

std::shared_ptr<const store::StoreReader> TemporaryStore::half_reader() const {
    store::StoreLayout layout = layout_in(folder_);
    layout.folder = folder_ / "half";
    layout.precision = core::Precision::Half;
    fs::create_directory(layout.folder);
    std::ofstream checksums(layout.folder / store::checksums_file_name, std::ios::binary);
    const auto single = reader();
    for (std::size_t i = 0; i < layout.times.size(); ++i) {
        const auto step = or_throw(single->load(i, {}));
        std::vector<std::uint16_t> halves(step->velocity().size());
        core::to_half(step->velocity(), halves);
        const auto bytes = std::as_bytes(std::span(halves));
        std::ofstream(layout.folder /
                          store::step_file_name(store::velocity_stem, i, layout.precision),
                      std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()));
        const std::uint32_t sum = core::crc32c(bytes);
        checksums.write(reinterpret_cast<const char*>(&sum), sizeof(sum));
    }
    checksums.flush();
    return open(std::move(layout));
}

} // namespace wakesurf::bench
