// Made by protocol/api/generate from errors.schema.json: do not edit.
#include "protocol/api/generated/errors.hpp"

namespace wakesurf::protocol {

std::string_view kind_of(RpcCode code) {
    switch (code) {
    case RpcCode::ParseError:
        return "parseError";
    case RpcCode::InvalidRequest:
        return "invalidRequest";
    case RpcCode::MethodNotFound:
        return "methodNotFound";
    case RpcCode::InvalidParameters:
        return "invalidParameters";
    case RpcCode::Cancelled:
        return "cancelled";
    case RpcCode::Stale:
        return "stale";
    case RpcCode::Unauthenticated:
        return "unauthenticated";
    case RpcCode::NotPermitted:
        return "notPermitted";
    case RpcCode::NotFound:
        return "notFound";
    case RpcCode::Leased:
        return "leased";
    case RpcCode::OutsideDomain:
        return "outsideDomain";
    case RpcCode::OutsideTimeRange:
        return "outsideTimeRange";
    case RpcCode::OverLimit:
        return "overLimit";
    case RpcCode::DatasetError:
        return "datasetError";
    case RpcCode::Internal:
        break;
    }
    return "internal";
}

} // namespace wakesurf::protocol
