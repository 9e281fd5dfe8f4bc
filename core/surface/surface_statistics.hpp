// What building a surface took and gave: the shape of `--stats` and `surface.stats`.
#pragma once

#include "core/integrate/curve.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/surface_parameters.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::core {

/// Why there is nothing to see of a surface, in words for people.
struct Emptiness {
    enum class Reason {
        InBody,
        OutsideCells,
        AtRest,
        NotFinite,
        SameRakes,
        NoArea,
        NothingYet,
        AllLeft,
        TooCoarse,
        OutsideRange
    };
    Reason reason;
    std::string message;
    std::string hint;

    /// The flow took everything away, and nothing is wrong with what was asked for.
    bool natural() const { return reason == Reason::AllLeft || reason == Reason::NothingYet; }
};

struct SurfaceStatistics {
    /// Particles released from the rake's seeds, by what ended them; of a surface that moves its vertices,
    /// but for those that lie on the boundary, which are new in every step.
    struct Terminated {
        std::uint64_t domain = 0, time = 0, obstacle = 0, stagnation = 0, budget = 0;

        void add(CurveEnd end) {
            domain += end == CurveEnd::Domain;
            time += end == CurveEnd::Time;
            obstacle += end == CurveEnd::Obstacle;
            stagnation += end == CurveEnd::Stagnation;
            budget += end == CurveEnd::Budget;
        }
    };

    struct Seconds {
        double load = 0, advect = 0, refine = 0, other = 0, total = 0;
    };

    SurfaceKind kind = SurfaceKind::Stream;
    std::uint64_t quads = 0;
    std::uint64_t vertices = 0;
    std::uint64_t steps = 0;        ///< integrator steps of the longest column
    std::uint64_t vertex_steps = 0; ///< integrator steps of all columns
    std::uint64_t approximated = 0;
    Terminated terminated;
    /// Of a level surface: the values of its field at that time.
    std::optional<std::array<double, 2>> field_range{};
    /// Cells of a streak or time surface that were deleted amid living particles, until then: these went
    /// apart, or came together, so much that no cells between them can follow.
    std::optional<std::uint64_t> torn{};
    double max_edge = 0;
    double separation = 0;           ///< longest edge allowed in the end
    double requested_separation = 0; ///< the one asked for
    Seconds seconds;
    std::optional<StatedError> error{};
    /// Of a path surface of both directions: where the data begin, if that cuts its backward side short.
    std::optional<double> data_end{};

    /// The quad budget did not allow the separation asked for.
    bool coarsened() const { return separation > requested_separation; }

    std::optional<Emptiness> empty{};
    std::string stopped{}; ///< why the surface ends before the time asked for; usually empty
};

} // namespace wakesurf::core
