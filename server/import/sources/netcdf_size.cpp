#include "server/import/sources/netcdf_size.hpp"

#include "core/base/disk.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

namespace wakesurf::server {

using core::Error;

namespace {

// Big-endian numbers one after the other; after the end all are 0 and `bad`.
class HeaderReader {
  public:
    HeaderReader(std::istream& in, int version) : in_(in), version_(version) {}

    std::uint64_t number(int bytes) {
        std::uint64_t out = 0;
        for (int i = 0; i < bytes; ++i)
            out = out << 8 | static_cast<std::uint8_t>(in_.get());
        return in_ ? out : 0;
    }

    std::uint64_t count() { return number(version_ == 5 ? 8 : 4); }

    std::uint64_t offset() { return number(version_ == 1 ? 4 : 8); }

    void skip(std::uint64_t bytes) {
        in_.seekg(static_cast<std::streamoff>((bytes + 3) / 4 * 4), std::ios::cur);
    }

    void skip_name() { skip(count()); }

    bool bad() const { return !in_; }

    void skip_attributes() {
        number(4); // a tag, or zeros where there are none
        for (auto left = count(); left > 0 && !bad(); --left) {
            skip_name();
            const auto size = size_of(number(4));
            skip(count() * size);
        }
    }

    static std::uint64_t size_of(std::uint64_t type) {
        constexpr std::uint64_t sizes[] = {1, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
        return type < std::size(sizes) ? sizes[type] : 1;
    }

  private:
    std::istream& in_;
    int version_;
};

// Bytes up to the end of the last value, without the padding behind it; nothing where this is no header.
std::optional<std::uint64_t> size_by_header(std::istream& in, int version) {
    HeaderReader header(in, version);
    const auto records = header.count();
    constexpr std::uint32_t streaming = 0xffffffffu;
    if (version != 5 && records == streaming)
        return std::uint64_t{0};
    header.number(4);
    std::vector<std::uint64_t> dimensions;
    for (auto left = header.count(); left > 0 && !header.bad(); --left) {
        header.skip_name();
        dimensions.push_back(header.count());
    }
    header.skip_attributes();
    header.number(4);
    std::uint64_t end = 0;
    std::uint64_t record = 0;
    std::vector<std::pair<std::uint64_t, std::uint64_t>>
        in_records; // where the first begins, its bytes
    for (auto left = header.count(); left > 0 && !header.bad(); --left) {
        header.skip_name();
        std::uint64_t values = 1;
        bool by_record = false;
        const auto axes = header.count();
        for (std::uint64_t axis = 0; axis < axes && !header.bad(); ++axis) {
            const auto id = header.count();
            if (id >= dimensions.size())
                return std::nullopt;
            by_record = by_record || dimensions[id] == 0;
            values *= dimensions[id] == 0 ? 1 : dimensions[id];
        }
        header.skip_attributes();
        const auto bytes = values * HeaderReader::size_of(header.number(4));
        header.count(); // the size again, which large variables do not fit into
        const auto begin = header.offset();
        if (by_record) {
            in_records.emplace_back(begin, bytes);
            record += (bytes + 3) / 4 * 4;
        } else {
            end = std::max(end, begin + bytes);
        }
    }
    if (header.bad())
        return std::nullopt;
    if (in_records.size() == 1)
        record = in_records.front().second;
    for (const auto& [begin, bytes] : in_records)
        if (records > 0)
            end = std::max(end, begin + (records - 1) * record + bytes);
    return end;
}

// Of HDF5, version 0 to 3: what stands behind its signature. Format: HDF5 File Format Specification, II.A.
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
        return core::fail(Error::Code::Corrupt, file.name + " is no NetCDF file");
    in.seekg(classic ? 4 : 8);
    const auto wanted = classic ? size_by_header(in, start[3]) : size_by_superblock(in);
    if (!wanted)
        return core::fail(Error::Code::Corrupt,
                          file.name + " ends within its header, or its header is damaged");
    if (*size < *wanted)
        return core::fail(Error::Code::Corrupt,
                          file.name + " ends too early: it has " + std::to_string(*size) +
                              " bytes, its header says " + std::to_string(*wanted),
                          "copy it again");
    return {};
}

} // namespace wakesurf::server
