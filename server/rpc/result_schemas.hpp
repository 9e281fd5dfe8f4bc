// What methods answer, as JSON Schema (draft 7): shapes that several share in components/schemas of the OpenRPC document,
// and one schema a method. Every member is named and nothing else may come, so that an answer can be checked against it.
#pragma once

#include "server/rpc/method.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

/// {Rake: ..., Surface: ..., Statistics: ..., Error: ..., ...}
nlohmann::json shared_schemas();

/// The method's own `traits.result_schema` where it has one that says more than "an object", else what is written here;
/// a method of neither answers any object.
nlohmann::json result_schema(const Method& method);

} // namespace wakesurf::server
