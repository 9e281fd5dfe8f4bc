#include "server/remote/zarr/zarr_attributes.hpp"

#include "core/base/plain_text.hpp"

#include <nlohmann/json.hpp>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr std::size_t longest_unit = 128; // of times with the date that they count from

/// Returns the number that stands for a missing value. null is a NaN, as parse_zarr_json leaves it; a text is
/// eight bytes of a double in base64, as xarray writes them into version 3. Empty for anything else.
std::optional<double> missing_number(const json& value) {
    if (value.is_null())
        return std::numeric_limits<double>::quiet_NaN();
    if (value.is_number())
        return value.get<double>();
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    std::array<unsigned char, 9> bytes{}; // the last one is padding
    if (text.size() != 12 || text.back() != '=' ||
        EVP_DecodeBlock(bytes.data(), reinterpret_cast<const unsigned char*>(text.data()), 12) != 9)
        return std::nullopt;
    double number = 0.0;
    std::memcpy(&number, bytes.data(), sizeof(number));
    return number;
}

/// Adds missing numbers. @param value  one, or a list
void add_missing(ZarrArray& array, const json& value) {
    constexpr std::size_t most = 8; // each number of the array is compared with all of them
    const json list = value.is_array() ? value : json::array({value});
    for (std::size_t i = 0; i < std::min(most, list.size()); ++i) {
        const auto number = missing_number(list[i]);
        if (number && std::isnan(*number))
            array.missing_is_nan = true;
        else if (number)
            array.missing.push_back(*number);
    }
}

void forget_odd_names(ZarrArray& array) {
    if (array.dimensions.size() != array.shape.size() ||
        !std::all_of(array.dimensions.begin(), array.dimensions.end(), is_plain_name))
        array.dimensions.clear();
}

} // namespace

void read_zarr_attributes(ZarrArray& array, const json& given) {
    const json attributes = given.is_object() ? given : json::object();
    const auto text = [&](const char* name) {
        const auto found = attributes.find(name);
        return found != attributes.end() && found->is_string() ? found->get<std::string>() : "";
    };
    const auto number = [&](const char* name) -> std::optional<double> {
        const auto found = attributes.find(name);
        return found != attributes.end() && found->is_number() ? std::optional(found->get<double>())
                                                               : std::nullopt;
    };
    array.unit = core::display_name(text("units"), longest_unit);
    array.scale = number("scale_factor").value_or(1.0);
    array.offset = number("add_offset").value_or(0.0);
    for (const char* name : {"_FillValue", "missing_value"})
        if (const auto found = attributes.find(name); found != attributes.end())
            add_missing(array, *found);
    // A fill value of 0 is most often a default without meaning.
    if (array.fill && *array.fill != 0.0 && std::isfinite(*array.fill))
        array.missing.push_back(*array.fill);
    const auto names = attributes.find("_ARRAY_DIMENSIONS");
    if (names != attributes.end() && names->is_array() && array.dimensions.empty())
        for (const json& each : *names)
            array.dimensions.push_back(each.is_string() ? each.get<std::string>() : "");
    forget_odd_names(array);
}

} // namespace wakesurf::server
