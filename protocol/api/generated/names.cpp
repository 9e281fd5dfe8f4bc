// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/names.hpp"

namespace wakesurf::protocol {

std::string_view name(core::Rake::Kind value) {
    switch (value) {
    case core::Rake::Kind::Line:
        return "line";
    case core::Rake::Kind::Polyline:
        return "polyline";
    case core::Rake::Kind::Circle:
        return "circle";
    case core::Rake::Kind::Points:
        return "points";
    }
    return {};
}

std::optional<core::Rake::Kind> rake_kind(std::string_view word) {
    if (word == "line")
        return core::Rake::Kind::Line;
    if (word == "polyline")
        return core::Rake::Kind::Polyline;
    if (word == "circle")
        return core::Rake::Kind::Circle;
    if (word == "points")
        return core::Rake::Kind::Points;
    return std::nullopt;
}

std::string_view name(core::SurfaceKind value) {
    switch (value) {
    case core::SurfaceKind::Stream:
        return "stream";
    case core::SurfaceKind::Path:
        return "path";
    case core::SurfaceKind::Streak:
        return "streak";
    case core::SurfaceKind::Time:
        return "time";
    case core::SurfaceKind::Level:
        return "level";
    }
    return {};
}

std::optional<core::SurfaceKind> surface_kind(std::string_view word) {
    if (word == "stream")
        return core::SurfaceKind::Stream;
    if (word == "path")
        return core::SurfaceKind::Path;
    if (word == "streak")
        return core::SurfaceKind::Streak;
    if (word == "time")
        return core::SurfaceKind::Time;
    if (word == "level")
        return core::SurfaceKind::Level;
    return std::nullopt;
}

std::string_view name(core::Direction value) {
    switch (value) {
    case core::Direction::Forward:
        return "forward";
    case core::Direction::Backward:
        return "backward";
    case core::Direction::Both:
        return "both";
    }
    return {};
}

std::optional<core::Direction> direction(std::string_view word) {
    if (word == "forward")
        return core::Direction::Forward;
    if (word == "backward")
        return core::Direction::Backward;
    if (word == "both")
        return core::Direction::Both;
    return std::nullopt;
}

std::string_view name(core::Accuracy value) {
    switch (value) {
    case core::Accuracy::Fast:
        return "fast";
    case core::Accuracy::Balanced:
        return "balanced";
    case core::Accuracy::Exact:
        return "exact";
    }
    return {};
}

std::optional<core::Accuracy> accuracy(std::string_view word) {
    if (word == "fast")
        return core::Accuracy::Fast;
    if (word == "balanced")
        return core::Accuracy::Balanced;
    if (word == "exact")
        return core::Accuracy::Exact;
    return std::nullopt;
}

std::string_view name(core::Interpolation value) {
    switch (value) {
    case core::Interpolation::Linear:
        return "linear";
    case core::Interpolation::Smooth:
        return "smooth";
    }
    return {};
}

std::optional<core::Interpolation> interpolation(std::string_view word) {
    if (word == "linear")
        return core::Interpolation::Linear;
    if (word == "smooth")
        return core::Interpolation::Smooth;
    return std::nullopt;
}

std::string_view name(core::Refine value) {
    switch (value) {
    case core::Refine::On:
        return "on";
    case core::Refine::Off:
        return "off";
    }
    return {};
}

std::optional<core::Refine> refine(std::string_view word) {
    if (word == "on")
        return core::Refine::On;
    if (word == "off")
        return core::Refine::Off;
    return std::nullopt;
}

std::string_view name(core::Emptiness::Reason value) {
    switch (value) {
    case core::Emptiness::Reason::InBody:
        return "inBody";
    case core::Emptiness::Reason::OutsideCells:
        return "outsideCells";
    case core::Emptiness::Reason::AtRest:
        return "atRest";
    case core::Emptiness::Reason::NotFinite:
        return "notFinite";
    case core::Emptiness::Reason::SameRakes:
        return "sameRakes";
    case core::Emptiness::Reason::NoArea:
        return "noArea";
    case core::Emptiness::Reason::NothingYet:
        return "nothingYet";
    case core::Emptiness::Reason::AllLeft:
        return "allLeft";
    case core::Emptiness::Reason::TooCoarse:
        return "tooCoarse";
    case core::Emptiness::Reason::OutsideRange:
        return "outsideRange";
    }
    return {};
}

std::optional<core::Emptiness::Reason> empty_reason(std::string_view word) {
    if (word == "inBody")
        return core::Emptiness::Reason::InBody;
    if (word == "outsideCells")
        return core::Emptiness::Reason::OutsideCells;
    if (word == "atRest")
        return core::Emptiness::Reason::AtRest;
    if (word == "notFinite")
        return core::Emptiness::Reason::NotFinite;
    if (word == "sameRakes")
        return core::Emptiness::Reason::SameRakes;
    if (word == "noArea")
        return core::Emptiness::Reason::NoArea;
    if (word == "nothingYet")
        return core::Emptiness::Reason::NothingYet;
    if (word == "allLeft")
        return core::Emptiness::Reason::AllLeft;
    if (word == "tooCoarse")
        return core::Emptiness::Reason::TooCoarse;
    if (word == "outsideRange")
        return core::Emptiness::Reason::OutsideRange;
    return std::nullopt;
}

} // namespace wakesurf::protocol
