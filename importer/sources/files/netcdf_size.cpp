#include "importer/sources/files/netcdf_size.hpp"

#include "core/base/disk.hpp"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

using core::Error;

namespace {

constexpr std::uint64_t largest = std::uint64_t{1} << 60; // bytes: beyond, a header is damaged

// Reads the header, number by number; everything is big-endian and padded to four bytes.
class Header {
  public:
    Header(std::istream& in, int version)
        : in_(in), count_(version == 5 ? 8 : 4), offset_(version == 1 ? 4 : 8) {}

    /// Returns the end of the last value of the last variable; empty if the header makes no sense.
    std::optional<std::uint64_t> end_of_data() {
        records_ = number(count_);
        if (!read_dimensions() || !skip_attributes())
            return std::nullopt;
        const auto tag = number(4);
        const auto variables = number(count_);
        if (!sound_ || (tag != 0 && tag != 11))
            return std::nullopt;
        for (std::uint64_t i = 0; i < variables; ++i)
            if (!read_variable())
                return std::nullopt;
        if (records_ == 0 || record_ends_ == 0)
            return fixed_ends_;
        if (record_bytes_ > largest ||
            (record_bytes_ > 0 && records_ - 1 > largest / record_bytes_))
            return std::nullopt;
        return std::max(fixed_ends_, record_ends_ + (records_ - 1) * record_size());
    }

    /// Says whether the number of records is that of streamed files, which do not state one. The netCDF
    /// library takes it for a count.
    bool streamed() const {
        return records_ == (count_ == 4 ? std::numeric_limits<std::uint32_t>::max()
                                        : std::numeric_limits<std::uint64_t>::max());
    }

  private:
    std::uint64_t number(std::size_t bytes) {
        std::array<char, 8> text{};
        in_.read(text.data(), static_cast<std::streamsize>(bytes));
        sound_ = sound_ && in_.good();
        std::uint64_t out = 0;
        for (std::size_t i = 0; i < bytes; ++i)
            out = out << 8 | static_cast<unsigned char>(text[i]);
        return out;
    }

    bool skip(std::uint64_t bytes) {
        sound_ = sound_ && bytes < largest;
        if (sound_)
            in_.seekg(static_cast<std::streamoff>((bytes + 3) / 4 * 4), std::ios::cur);
        return sound_ && in_.good();
    }

    // The netCDF library copies a name of any length into buffers for the longest allowed one.
    bool skip_name() {
        const auto bytes = number(count_);
        return bytes <= NC_MAX_NAME && skip(bytes);
    }

    static std::uint64_t bytes_of(std::uint64_t type) {
        constexpr std::array<std::uint64_t, 12> sizes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
        return type < sizes.size() ? sizes[type] : 0;
    }

    bool read_dimensions() {
        const auto tag = number(4);
        const auto count = number(count_);
        if (!sound_ || (tag != 0 && tag != 10))
            return false;
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!skip_name())
                return false;
            lengths_.push_back(number(count_));
        }
        return sound_;
    }

    bool skip_attributes() {
        const auto tag = number(4);
        const auto count = number(count_);
        if (!sound_ || (tag != 0 && tag != 12))
            return false;
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!skip_name())
                return false;
            const auto bytes = bytes_of(number(4));
            const auto values = number(count_);
            if (bytes == 0 || values > largest / 8 || !skip(bytes * values))
                return false;
        }
        return sound_;
    }

    bool read_variable() {
        if (!skip_name())
            return false;
        const auto rank = number(count_);
        if (rank > NC_MAX_VAR_DIMS)
            return false;
        std::uint64_t values = 1;
        bool record = false;
        for (std::uint64_t d = 0; d < rank && sound_; ++d) {
            const auto id = number(count_);
            if (id >= lengths_.size())
                return false;
            if (d == 0 && lengths_[id] == 0)
                record = true;
            else if (lengths_[id] != 0 && values > largest / lengths_[id])
                return false;
            else
                values *= lengths_[id];
        }
        if (!skip_attributes())
            return false;
        const auto bytes = bytes_of(number(4));
        number(count_); // the size, wrong for large variables
        const auto begin = number(offset_);
        if (!sound_ || bytes == 0 || values > largest / 8 || begin > largest)
            return false;
        if (!record) {
            fixed_ends_ = std::max(fixed_ends_, begin + values * bytes);
            return true;
        }
        ++record_variables_;
        last_record_ = values * bytes;
        record_bytes_ += (values * bytes + 3) / 4 * 4;
        record_ends_ = std::max(record_ends_, begin + values * bytes);
        return true;
    }

    // The records of a single variable are not padded.
    std::uint64_t record_size() const {
        return record_variables_ == 1 ? last_record_ : record_bytes_;
    }

    std::istream& in_;
    std::size_t count_;
    std::size_t offset_;
    bool sound_ = true;
    std::uint64_t records_ = 0;
    std::vector<std::uint64_t> lengths_;
    std::uint64_t fixed_ends_ = 0;
    std::uint64_t record_ends_ = 0;
    std::uint64_t record_bytes_ = 0;
    std::uint64_t last_record_ = 0;
    std::uint64_t record_variables_ = 0;
};

// Returns the size that the superblock of HDF5, version 0 to 3, states behind its signature. Format: HDF5
// File Format Specification, II.A.
std::optional<std::uint64_t> size_by_superblock(std::istream& in) {
    std::array<unsigned char, 52> bytes{};
    in.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    const int version = bytes[0];
    const int size_of_offsets = version < 2 ? bytes[5] : bytes[1];
    if (!in || version > 3 || size_of_offsets != 8)
        return std::nullopt;
    const std::size_t addresses = version == 0 ? 16 : version == 1 ? 20 : 4;
    constexpr std::size_t end_of_file = 16;
    std::uint64_t out = 0;
    for (std::size_t i = 8; i-- > 0;)
        out = out << 8 | bytes[addresses + end_of_file + i];
    return out;
}

} // namespace

core::Result<void> check_netcdf_size(const NamedFile& file) {
    const auto size = core::PosixDisk().size(file.path);
    if (!size && size.error().code == Error::Code::NotFound)
        return core::fail(Error::Code::NotFound, file.name + " is not there");
    if (!size)
        return tl::unexpected(size.error());
    std::ifstream in(file.path, std::ios::binary);
    std::array<char, 8> magic{};
    in.read(magic.data(), magic.size());
    const std::string_view start(magic.data(), static_cast<std::size_t>(in.gcount()));
    const bool classic = start.size() > 3 && start.starts_with("CDF") &&
                         (start[3] == 1 || start[3] == 2 || start[3] == 5);
    if (!classic && start != "\x89HDF\r\n\x1a\n")
        return core::fail(Error::Code::Corrupt, file.name + " is not a NetCDF file");
    in.seekg(classic ? 4 : 8);
    Header header(in, start[3]);
    const auto wanted = classic ? header.end_of_data() : size_by_superblock(in);
    if (classic && header.streamed())
        return core::fail(Error::Code::Unsupported,
                          file.name + " does not say how many time-steps it has: it was streamed, "
                                      "or is still being written",
                          "write the whole file to a disk");
    if (!wanted)
        return core::fail(Error::Code::Corrupt,
                          file.name + " ends within its header, or its header is damaged");
    if (*size < *wanted)
        return core::fail(Error::Code::Corrupt,
                          file.name + " ends too early: it has " + std::to_string(*size) +
                              " bytes, but its header says " + std::to_string(*wanted),
                          "copy it again");
    return {};
}

} // namespace wakesurf::importer
