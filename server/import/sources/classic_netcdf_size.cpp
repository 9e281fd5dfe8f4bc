#include "server/import/sources/classic_netcdf_size.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>

namespace wakesurf::server {

using core::Error;

namespace {

constexpr std::uint64_t most = std::uint64_t{1} << 60; // bytes: beyond, a header is damaged

// What the header says, number by number; everything is big-endian and padded to four bytes.
class Header {
  public:
    explicit Header(std::ifstream& in, int version)
        : in_(in), count_(version == 5 ? 8 : 4), offset_(version == 1 ? 4 : 8) {}

    /// The end of the last value of the last variable; nothing where the header makes no sense.
    std::optional<std::uint64_t> end_of_data() {
        const auto records = number(count_);
        if (!read_dimensions() || !skip_attributes())
            return std::nullopt;
        const auto tag = number(4);
        const auto variables = number(count_);
        if (!sound_ || (tag != 0 && tag != 11))
            return std::nullopt;
        for (std::uint64_t i = 0; i < variables; ++i)
            if (!read_variable())
                return std::nullopt;
        // Streamed files do not say how many records they have.
        const auto streaming = count_ == 4 ? std::numeric_limits<std::uint32_t>::max()
                                           : std::numeric_limits<std::uint64_t>::max();
        if (records == streaming || records == 0 || record_ends_ == 0)
            return fixed_ends_;
        if (record_bytes_ > 0 && records - 1 > most / record_bytes_)
            return std::nullopt;
        return std::max(fixed_ends_, record_ends_ + (records - 1) * record_size());
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
        sound_ = sound_ && bytes < most;
        if (sound_)
            in_.seekg(static_cast<std::streamoff>((bytes + 3) / 4 * 4), std::ios::cur);
        return sound_ && in_.good();
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
            if (!skip(number(count_)))
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
            if (!skip(number(count_)))
                return false;
            const auto bytes = bytes_of(number(4));
            const auto values = number(count_);
            if (bytes == 0 || values > most / 8 || !skip(bytes * values))
                return false;
        }
        return sound_;
    }

    bool read_variable() {
        if (!skip(number(count_)))
            return false;
        const auto rank = number(count_);
        std::uint64_t values = 1;
        bool record = false;
        for (std::uint64_t d = 0; d < rank && sound_; ++d) {
            const auto id = number(count_);
            if (id >= lengths_.size())
                return false;
            if (d == 0 && lengths_[id] == 0)
                record = true;
            else if (lengths_[id] != 0 && values > most / lengths_[id])
                return false;
            else
                values *= lengths_[id];
        }
        if (!skip_attributes())
            return false;
        const auto bytes = bytes_of(number(4));
        number(count_); // the size, wrong for large variables
        const auto begin = number(offset_);
        if (!sound_ || bytes == 0 || values > most / 8 || begin > most)
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

    std::ifstream& in_;
    std::size_t count_;
    std::size_t offset_;
    bool sound_ = true;
    std::vector<std::uint64_t> lengths_;
    std::uint64_t fixed_ends_ = 0;
    std::uint64_t record_ends_ = 0;
    std::uint64_t record_bytes_ = 0;
    std::uint64_t last_record_ = 0;
    std::uint64_t record_variables_ = 0;
};

} // namespace

core::Result<void> check_classic_netcdf_size(const ListedFile& file) {
    std::ifstream in(file.path, std::ios::binary);
    if (!in)
        return core::fail(Error::Code::Io, "cannot open " + file.name);
    std::array<char, 4> magic{};
    in.read(magic.data(), magic.size());
    const int version = magic[3];
    if (!in || magic[0] != 'C' || magic[1] != 'D' || magic[2] != 'F' ||
        (version != 1 && version != 2 && version != 5))
        return {};
    const auto end = Header(in, version).end_of_data();
    if (!end)
        return core::fail(Error::Code::Corrupt, file.name + " has a damaged header");
    in.clear();
    in.seekg(0, std::ios::end);
    const auto size = static_cast<std::uint64_t>(in.tellg());
    if (size < *end)
        return core::fail(Error::Code::Corrupt, file.name + " is truncated: it has " +
                                                    std::to_string(size) + " of " +
                                                    std::to_string(*end) + " bytes");
    return {};
}

} // namespace wakesurf::server
