#include "protocol/api/base/json_text.hpp"

#include "protocol/api/base/json_fault.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

namespace {

struct Shape {
    std::size_t deepest = 0;
    std::size_t values = 1;  ///< at most so many
    std::size_t members = 0; ///< of all objects
};

Shape shape_of(std::string_view text) {
    Shape shape;
    std::size_t depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            i += c == '\\' ? 1 : 0;
            quoted = c != '"';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '[' || c == '{') {
            shape.deepest = std::max(shape.deepest, ++depth);
            ++shape.values;
        } else if (c == ',') {
            ++shape.values;
        } else if (c == ':') {
            ++shape.members;
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return shape;
}

/// Where a member comes twice there are fewer of them than in the text.
std::size_t members_of(const nlohmann::json& value) {
    if (!value.is_structured())
        return 0;
    std::size_t members = value.is_object() ? value.size() : 0;
    for (const auto& each : value)
        members += members_of(each);
    return members;
}

} // namespace

core::Result<nlohmann::json> parse_json(std::string_view text, JsonLimits limits) {
    using core::Error;
    if (text.size() > limits.bytes)
        return core::fail(Error::Code::OverLimit, "the JSON text is longer than " +
                                                      std::to_string(limits.bytes) + " bytes");
    const Shape shape = shape_of(text);
    if (shape.deepest > limits.depth)
        return core::fail(Error::Code::OverLimit, "the JSON text is nested deeper than " +
                                                      std::to_string(limits.depth) + " levels");
    if (shape.values > limits.values)
        return core::fail(Error::Code::OverLimit, "the JSON text has more than " +
                                                      std::to_string(limits.values) + " values");
    auto value = nlohmann::json::parse(text, nullptr, false);
    if (value.is_discarded()) {
        JsonFault fault = json_fault(text);
        return core::fail(Error::Code::Corrupt, std::move(fault.message), std::move(fault.hint));
    }
    if (members_of(value) != shape.members) {
        JsonFault fault = member_twice(text);
        return core::fail(Error::Code::InvalidArgument, std::move(fault.message),
                          std::move(fault.hint));
    }
    return value;
}

std::string json_text(const nlohmann::json& value, int indent) {
    return value.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace wakesurf::protocol
