// Made by protocol/api/generate from errors.schema.json: do not edit.
#include "protocol/api/generated/errors.hpp"

#include <utility>

namespace wakesurf::protocol {

std::string_view kind_of(RpcCode code) {
    static constexpr std::pair<RpcCode, std::string_view> kinds[]{
        {RpcCode::ParseError, "parseError"},
        {RpcCode::InvalidRequest, "invalidRequest"},
        {RpcCode::MethodNotFound, "methodNotFound"},
        {RpcCode::InvalidParameters, "invalidParameters"},
        {RpcCode::Internal, "internal"},
        {RpcCode::Cancelled, "cancelled"},
        {RpcCode::Stale, "stale"},
        {RpcCode::Unauthenticated, "unauthenticated"},
        {RpcCode::NotPermitted, "notPermitted"},
        {RpcCode::NotFound, "notFound"},
        {RpcCode::Leased, "leased"},
        {RpcCode::OutsideDomain, "outsideDomain"},
        {RpcCode::OutsideTimeRange, "outsideTimeRange"},
        {RpcCode::OverLimit, "overLimit"},
        {RpcCode::DatasetError, "datasetError"}};
    for (const auto& [each, kind] : kinds)
        if (each == code)
            return kind;
    return "internal";
}

} // namespace wakesurf::protocol
