// Errors as values: what went wrong in one sentence, and what the caller can do about it.
#pragma once

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::core {

/// An error, for a program and for a person.
struct Error {
    /// The kind of error, by which a program decides.
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
    /// The time up to which a series with an unreadable time-step can be read, in the direction of the run.
    std::optional<double> readable_until{};
    /// The largest value allowed, for OverLimit; empty if the machine's memory ran out.
    std::optional<std::uint64_t> limit{};
};

template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for `return fail(Error::Code::NotFound, "no rake r7", "list them with rake.list")`.
inline tl::unexpected<Error> fail(Error::Code code, std::string message, std::string hint = {}) {
    return tl::unexpected(Error{code, std::move(message), std::move(hint)});
}

/// Returns the error of more than `limit` of something.
inline tl::unexpected<Error>
over_limit(std::uint64_t limit, std::string message, std::string hint = {}) {
    return tl::unexpected(
        Error{Error::Code::OverLimit, std::move(message), std::move(hint), {}, limit});
}

} // namespace wakesurf::core
