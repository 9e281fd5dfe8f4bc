// Errors as values: what went wrong in one sentence, and what the caller can do about it.
#pragma once

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::core {

/// What went wrong, for a program and for a person.
struct Error {
    /// What kind of fault: what a program decides by.
    enum class Code {
        NotFound,
        Corrupt,
        Unsupported,
        InvalidArgument,
        OutOfDomain,
        OutOfTime,
        OverLimit,
        Cancelled,
        Io
    };
    Code code = Code::Io; ///< what kind of fault it is
    std::string message;  ///< one sentence for a person, without a server path
    std::string hint;     ///< what to do about it; may be empty
    /// Of a time-step that cannot be read: the time up to which the series can, on the way things were going.
    std::optional<double> readable_until{};
    /// Of OverLimit: the most there may be. Nothing: what ran out is the machine's memory.
    std::optional<std::uint64_t> limit{};
};

template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for `return fail(Error::Code::NotFound, "no rake r7", "list them with rake.list")`.
inline tl::unexpected<Error> fail(Error::Code code, std::string message, std::string hint = {}) {
    return tl::unexpected(Error{code, std::move(message), std::move(hint)});
}

/// The same for more than `limit` of something.
inline tl::unexpected<Error>
over_limit(std::uint64_t limit, std::string message, std::string hint = {}) {
    return tl::unexpected(
        Error{Error::Code::OverLimit, std::move(message), std::move(hint), {}, limit});
}

} // namespace wakesurf::core
