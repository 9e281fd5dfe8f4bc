// Made by protocol/api/generate from *.schema.json: do not edit.
// The parts of the OpenRPC document, each the inside of a list or an object.
#pragma once

#include <string_view>

namespace wakesurf::protocol::openrpc {

extern const std::string_view methods_1;
extern const std::string_view methods_2;
extern const std::string_view methods_3;
extern const std::string_view methods_4;
extern const std::string_view methods_5;
extern const std::string_view methods_6;
extern const std::string_view methods_7;
extern const std::string_view methods_8;
extern const std::string_view methods_9;
extern const std::string_view methods_10;
inline constexpr const std::string_view* methods[]{&methods_1, &methods_2, &methods_3, &methods_4,
                                                   &methods_5, &methods_6, &methods_7, &methods_8,
                                                   &methods_9, &methods_10};

extern const std::string_view schemas_1;
extern const std::string_view schemas_2;
extern const std::string_view schemas_3;
extern const std::string_view schemas_4;
inline constexpr const std::string_view* schemas[]{&schemas_1, &schemas_2, &schemas_3, &schemas_4};

extern const std::string_view errors_1;
inline constexpr const std::string_view* errors[]{&errors_1};

} // namespace wakesurf::protocol::openrpc
