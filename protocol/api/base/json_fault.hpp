// Why a text is not taken for JSON, in words that name the place: most often a script has sent NaN.
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::protocol {

struct JsonFault {
    std::string message;
    std::string hint;
};

/// REQUIRES: nlohmann::json::parse refuses the text. Cost: as parsing it.
JsonFault json_fault(std::string_view text);

/// REQUIRES: JSON of which an object has a member twice.
JsonFault member_twice(std::string_view text);

} // namespace wakesurf::protocol
