#include "server/remote/zarr/zarr_numbers.hpp"

#include <nlohmann/json.hpp>

#include <bit>
#include <charconv>
#include <limits>
#include <string>

namespace wakesurf::server {

using core::Error;
using core::Result;
using nlohmann::json;

namespace {

/// Parses the bits of a number, as version 3 may write them: "0x7fc00000".
std::optional<double> number_of_bits(const ZarrArray& array, std::string_view text) {
    std::uint64_t bits = 0;
    const auto read = std::from_chars(text.data() + 2, text.data() + text.size(), bits, 16);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() ||
        text.size() != 2 + 2 * array.number_bytes)
        return std::nullopt;
    if (array.number_bytes == 4)
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (array.number_bytes == 8)
        return std::bit_cast<double>(bits);
    const bool none = (bits & 0x7c00u) == 0x7c00u && (bits & 0x3ffu) != 0;
    return none ? std::optional(std::numeric_limits<double>::quiet_NaN()) : std::nullopt;
}

} // namespace

bool read_zarr_type(ZarrArray& array, std::string_view text) {
    if (text.size() != 3 || text[2] < '1' || text[2] > '8')
        return false;
    array.big_endian = text[0] == '>';
    array.number = text[1] == 'f'   ? ZarrArray::Number::Float
                   : text[1] == 'i' ? ZarrArray::Number::Signed
                                    : ZarrArray::Number::Unsigned;
    array.number_bytes = static_cast<std::size_t>(text[2] - '0');
    return std::string_view("<>|").find(text[0]) != std::string_view::npos &&
           std::string_view("fiu").find(text[1]) != std::string_view::npos &&
           std::has_single_bit(array.number_bytes) && (text[1] != 'f' || array.number_bytes > 1);
}

bool read_zarr_type_name(ZarrArray& array, std::string_view text) {
    for (const auto& [name, number] : {std::pair{"float", 'f'}, {"int", 'i'}, {"uint", 'u'}}) {
        if (!text.starts_with(name))
            continue;
        const auto bits = text.substr(std::string_view(name).size());
        for (const auto& [said, bytes] :
             {std::pair{"8", '1'}, {"16", '2'}, {"32", '4'}, {"64", '8'}})
            if (bits == said)
                return read_zarr_type(array, std::string{'<', number, bytes});
    }
    return false;
}

Result<std::optional<double>> read_zarr_fill(const ZarrArray& array, const json& value) {
    if (value.is_null())
        return std::optional<double>();
    if (value.is_number())
        return std::optional(value.get<double>());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    if (text == "NaN")
        return std::optional(std::numeric_limits<double>::quiet_NaN());
    if (text == "Infinity" || text == "-Infinity")
        return std::optional(text[0] == '-' ? -infinity : infinity);
    if (array.number == ZarrArray::Number::Float && text.starts_with("0x"))
        if (const auto number = number_of_bits(array, text))
            return number;
    return core::fail(Error::Code::Corrupt, "its fill_value is no number");
}

} // namespace wakesurf::server
