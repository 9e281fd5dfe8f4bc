// Lists of values as JSON arrays.
#pragma once

#include <iterator>
#include <type_traits>

namespace wakesurf::protocol {

/// Returns the array of what `write` makes of each value. Its callers include the JSON library, which is no
/// header's matter.
template <class Values, class Write>
auto list_json(const Values& values, Write write) {
    using Json = std::invoke_result_t<Write, decltype(*std::begin(values))>;
    Json list = Json::array();
    for (const auto& each : values)
        list.push_back(write(each));
    return list;
}

} // namespace wakesurf::protocol
