// A store of a few bytes made by hand: it may hold what the importer would never write.
#pragma once

#include "core/base/crc32c.hpp"
#include "core/base/half.hpp"
#include "store/store_grid.hpp"
#include "store/store_reader.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::tests {

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

inline std::uint32_t checksum_of(std::string_view bytes) {
    return core::crc32c(std::as_bytes(std::span(bytes)));
}

/// Appends the record that makes the next time-step ready.
inline void append_checksums(const store::StoreLayout& layout,
                             const std::vector<std::uint32_t>& checksums) {
    std::ofstream(layout.folder / store::checksums_file_name, std::ios::binary | std::ios::app)
        << bytes_of(checksums);
}

/// Writes the file of a time-step alone, which does not make it ready.
inline std::uint32_t put_values(const store::StoreLayout& layout,
                                std::string_view stem,
                                std::size_t index,
                                const std::vector<float>& values) {
    std::vector<std::uint16_t> halves(values.size());
    core::to_half(values, halves);
    const std::string bytes =
        layout.precision == core::Precision::Half ? bytes_of(halves) : bytes_of(values);
    write_file(layout.folder / store::step_file_name(stem, index, layout.precision), bytes);
    return checksum_of(bytes);
}

/// Writes time-step `index` of a store without scalars; those before it must exist.
inline void
put_step(const store::StoreLayout& layout, std::size_t index, const std::vector<float>& velocity) {
    append_checksums(layout, {put_values(layout, store::velocity_stem, index, velocity)});
}

/// Writes a file that all time-steps share.
inline void
put_fixed(store::StoreLayout& layout, const std::string& name, const std::string& bytes) {
    write_file(layout.folder / name, bytes);
    layout.checksums[name] = checksum_of(bytes);
}

inline core::Result<std::shared_ptr<const store::StoreReader>>
open_layout(const store::StoreLayout& layout) {
    return store::StoreReader::open(layout, std::make_shared<core::PosixDisk>());
}

inline void flip_bit(const std::filesystem::path& file, std::size_t bit) {
    std::string bytes = read_file(file);
    bytes.at(bit / 8) = static_cast<char>(bytes.at(bit / 8) ^ (1 << bit % 8));
    write_file(file, bytes);
}

} // namespace wakesurf::tests
