#include "protocol/api/surface_names.hpp"

#include <array>
#include <utility>

namespace wakesurf::protocol {

namespace {

constexpr std::array<std::pair<core::SurfaceKind, std::string_view>, 4> kinds{
    {{core::SurfaceKind::Stream, "stream"},
     {core::SurfaceKind::Path, "path"},
     {core::SurfaceKind::Streak, "streak"},
     {core::SurfaceKind::Time, "time"}}};
constexpr std::array<std::pair<core::Direction, std::string_view>, 3> directions{
    {{core::Direction::Forward, "forward"},
     {core::Direction::Backward, "backward"},
     {core::Direction::Both, "both"}}};
constexpr std::array<std::pair<core::Accuracy, std::string_view>, 3> accuracies{
    {{core::Accuracy::Fast, "fast"},
     {core::Accuracy::Balanced, "balanced"},
     {core::Accuracy::Exact, "exact"}}};

template <class Table, class Enum>
std::string_view word_of(const Table& table, Enum value) {
    for (const auto& [each, word] : table) {
        if (each == value)
            return word;
    }
    return {};
}

template <class Enum, class Table>
std::optional<Enum> value_of(const Table& table, std::string_view word) {
    for (const auto& [each, name] : table) {
        if (name == word)
            return each;
    }
    return std::nullopt;
}

} // namespace

std::string_view name(core::SurfaceKind kind) {
    return word_of(kinds, kind);
}

std::string_view name(core::Direction direction) {
    return word_of(directions, direction);
}

std::string_view name(core::Accuracy accuracy) {
    return word_of(accuracies, accuracy);
}

std::optional<core::SurfaceKind> surface_kind(std::string_view word) {
    return value_of<core::SurfaceKind>(kinds, word);
}

std::optional<core::Direction> direction(std::string_view word) {
    return value_of<core::Direction>(directions, word);
}

std::optional<core::Accuracy> accuracy(std::string_view word) {
    return value_of<core::Accuracy>(accuracies, word);
}

} // namespace wakesurf::protocol
