// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/names.hpp"

namespace wakesurf::protocol {

namespace {

template <class Value>
struct Word {
    Value value;
    std::string_view text;
};

template <class Value, std::size_t count>
std::string_view text_of(Value value, const Word<Value> (&words)[count]) {
    for (const Word<Value>& each : words)
        if (each.value == value)
            return each.text;
    return {};
}

template <class Value, std::size_t count>
std::optional<Value> value_of(std::string_view text, const Word<Value> (&words)[count]) {
    for (const Word<Value>& each : words)
        if (each.text == text)
            return each.value;
    return std::nullopt;
}

constexpr Word<core::Rake::Kind> words_of_rake_kind[]{{core::Rake::Kind::Line, "line"},
                                                      {core::Rake::Kind::Polyline, "polyline"},
                                                      {core::Rake::Kind::Circle, "circle"},
                                                      {core::Rake::Kind::Points, "points"}};
constexpr Word<core::SurfaceKind> words_of_surface_kind[]{{core::SurfaceKind::Stream, "stream"},
                                                          {core::SurfaceKind::Path, "path"},
                                                          {core::SurfaceKind::Streak, "streak"},
                                                          {core::SurfaceKind::Time, "time"},
                                                          {core::SurfaceKind::Level, "level"}};
constexpr Word<core::Direction> words_of_direction[]{{core::Direction::Forward, "forward"},
                                                     {core::Direction::Backward, "backward"},
                                                     {core::Direction::Both, "both"}};
constexpr Word<core::Accuracy> words_of_accuracy[]{{core::Accuracy::Fast, "fast"},
                                                   {core::Accuracy::Balanced, "balanced"},
                                                   {core::Accuracy::Exact, "exact"}};
constexpr Word<core::Interpolation> words_of_interpolation[]{
    {core::Interpolation::Linear, "linear"}, {core::Interpolation::Smooth, "smooth"}};
constexpr Word<core::Refine> words_of_refine[]{{core::Refine::On, "on"},
                                               {core::Refine::Off, "off"}};
constexpr Word<core::Emptiness::Reason> words_of_empty_reason[]{
    {core::Emptiness::Reason::InBody, "inBody"},
    {core::Emptiness::Reason::OutsideCells, "outsideCells"},
    {core::Emptiness::Reason::AtRest, "atRest"},
    {core::Emptiness::Reason::NotFinite, "notFinite"},
    {core::Emptiness::Reason::SameRakes, "sameRakes"},
    {core::Emptiness::Reason::NoArea, "noArea"},
    {core::Emptiness::Reason::NothingYet, "nothingYet"},
    {core::Emptiness::Reason::AllLeft, "allLeft"},
    {core::Emptiness::Reason::TooCoarse, "tooCoarse"},
    {core::Emptiness::Reason::OutsideRange, "outsideRange"}};

} // namespace

std::string_view name(core::Rake::Kind value) {
    return text_of(value, words_of_rake_kind);
}

std::optional<core::Rake::Kind> rake_kind(std::string_view word) {
    return value_of(word, words_of_rake_kind);
}

std::string_view name(core::SurfaceKind value) {
    return text_of(value, words_of_surface_kind);
}

std::optional<core::SurfaceKind> surface_kind(std::string_view word) {
    return value_of(word, words_of_surface_kind);
}

std::string_view name(core::Direction value) {
    return text_of(value, words_of_direction);
}

std::optional<core::Direction> direction(std::string_view word) {
    return value_of(word, words_of_direction);
}

std::string_view name(core::Accuracy value) {
    return text_of(value, words_of_accuracy);
}

std::optional<core::Accuracy> accuracy(std::string_view word) {
    return value_of(word, words_of_accuracy);
}

std::string_view name(core::Interpolation value) {
    return text_of(value, words_of_interpolation);
}

std::optional<core::Interpolation> interpolation(std::string_view word) {
    return value_of(word, words_of_interpolation);
}

std::string_view name(core::Refine value) {
    return text_of(value, words_of_refine);
}

std::optional<core::Refine> refine(std::string_view word) {
    return value_of(word, words_of_refine);
}

std::string_view name(core::Emptiness::Reason value) {
    return text_of(value, words_of_empty_reason);
}

std::optional<core::Emptiness::Reason> empty_reason(std::string_view word) {
    return value_of(word, words_of_empty_reason);
}

} // namespace wakesurf::protocol
