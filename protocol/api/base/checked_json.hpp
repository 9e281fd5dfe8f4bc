// Parameters of a method -> checked values. A reader, made from the description of the API, asks for each
// parameter by name; the first fault is kept with that name. What no reader asked for is a fault as well, so
// that a misspelt parameter is never ignored.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"

#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// A parameter of which null says something else than leaving it out.
/// Given without a value: null.
template <class T>
struct Nullable {
    bool given = false;
    std::optional<T> value;

    bool operator==(const Nullable&) const = default;
};

/// Colours, as they are written in messages and records.
/// #rrggbb
constexpr bool is_colour(std::string_view text) {
    const auto digit = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    return text.size() == 7 && text.front() == '#' &&
           std::all_of(text.begin() + 1, text.end(), digit);
}

// Bounds that bound nothing: what a description leaves open.
inline constexpr double any_number = std::numeric_limits<double>::max();
inline constexpr std::uint64_t most_whole = std::uint64_t{1} << 53; ///< exact in every JSON reader
inline constexpr std::size_t most_items = std::numeric_limits<std::size_t>::max();

/// Numbers are finite after narrowing and in range, or a fault that names the parameter. A parameter that is
/// null counts as left out. After a fault the getters give the fallback; verdict() tells.
class CheckedJson {
  public:
    /// `object` must outlive this. An array is a fault: parameters have names here.
    explicit CheckedJson(const nlohmann::json& object);

    bool has(std::string_view name);

    /// Is true also with null, where that says something.
    bool given(std::string_view name);

    std::string text(std::string_view name, std::size_t longest = 256);
    std::string text_or(std::string_view name, std::string fallback, std::size_t longest = 256);
    std::optional<std::string> text_if(std::string_view name, std::size_t longest = 256);
    /// Do as text() and text_if(), and an empty text is a fault.
    std::string some_text(std::string_view name, std::size_t longest);
    std::optional<std::string> some_text_if(std::string_view name, std::size_t longest);
    /// Reads text of several lines: line breaks and tabs are no fault.
    std::string lines(std::string_view name, std::size_t longest);
    /// Reads an object, as compact JSON text of at most `longest` bytes.
    std::string object_text(std::string_view name, std::size_t longest);
    bool flag_or(std::string_view name, bool fallback);
    double number(std::string_view name, double lo, double hi);
    double number_or(std::string_view name, double lo, double hi, double fallback);
    std::optional<double> number_if(std::string_view name, double lo, double hi);
    std::uint64_t count(std::string_view name, std::uint64_t lo, std::uint64_t hi);
    std::uint64_t
    count_or(std::string_view name, std::uint64_t lo, std::uint64_t hi, std::uint64_t fallback);
    std::optional<std::uint64_t>
    count_if(std::string_view name, std::uint64_t lo, std::uint64_t hi);
    core::Vec3 point(std::string_view name);
    std::optional<core::Vec3> point_if(std::string_view name);
    std::vector<core::Vec3> points(std::string_view name, std::size_t most);
    std::vector<std::string> texts_or_none(std::string_view name, std::size_t most);

    /// Reads a string or a number (a whole one, where `whole`), as its JSON text.
    std::string token(std::string_view name, bool whole);
    std::optional<std::string> token_if(std::string_view name, bool whole);

    /// Sets `out` to what `parse` makes of the member's `text`; one that it does not know is a fault, which
    /// says the `words` it knows.
    template <class Value, class Out>
    void word(std::string_view name,
              std::string_view text,
              std::optional<Value> (*parse)(std::string_view),
              Out& out,
              const char* words) {
        if (const auto found = parse(text))
            out = *found;
        else
            fault(name, std::string("must be ") + words);
    }

    /// Hands `read` the object's own reader; the first fault inside becomes one of `name`.
    void inside(std::string_view name, const std::function<void(CheckedJson&)>& read);

    void fault(std::string_view name, std::string_view problem);

    /// Returns InvalidArgument with the first fault, or with the first unknown parameter.
    core::Result<void> verdict();

    /// Returns the same for a record from a file: Corrupt; unknown members are left to newer versions.
    core::Result<void> record_verdict() const;

  private:
    const nlohmann::json* find(std::string_view name);
    const nlohmann::json* need(std::string_view name);

    const nlohmann::json& object_;
    std::vector<std::string> known_;
    std::string fault_;
    std::string hint_; ///< of an unknown name; the words of all others say what is wanted
};

} // namespace wakesurf::protocol
