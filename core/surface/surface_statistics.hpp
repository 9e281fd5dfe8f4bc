// The cost and the result of building a surface: the shape of `--stats` and `surface.stats`.
#pragma once

#include "core/integrate/curve.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/surface_parameters.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::core {

/// The reason why there is nothing to see of a surface, in words for people.
struct Emptiness {
    /// The reasons by which a program decides.
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
    Reason reason;       ///< the reason, for programs
    std::string message; ///< one sentence for people
    std::string hint;    ///< what to do about it

    /// The flow took everything away, and nothing is wrong with what was asked for.
    bool natural() const { return reason == Reason::AllLeft || reason == Reason::NothingYet; }
};

/// Sums up the errors of a surface's vertices that come from interpolating between stored times.
struct StatedIntervalError {
    /// A length: 99 % of the vertices that are resolved have no larger error.
    double error99 = 0.0;
    /// The share of the traced vertices for which the stored times are too far apart to say more.
    double unresolved = 0.0;
};

/// How far a surface is from its twin. Distances are between particles of the same seed and release, in units of length.
struct TwinDistance {
    double age = 0.0;      ///< of the oldest particle counted
    double compared = 0.0; ///< share of the particles that arrive in both
    double p50 = 0.0;      ///< half of these are no farther apart
    double p90 = 0.0;
    double p99 = 0.0;
    /// The median of the times by which the twin's particle comes later along the flow; negative: earlier.
    double lag50 = 0.0;
};

/// A surface beside its twin: all of it, and by age.
struct StatedTwin {
    TwinDistance all;
    std::vector<TwinDistance>
        ages; ///< in parts of equal length of the oldest age; those with particles
};

/// Counts and times of a surface, for programs and people.
struct SurfaceStatistics {
    /// Particles released from the rake's seeds, by what ended them; of a surface that moves its vertices,
    /// but for those that lie on the boundary, which are new in every step.
    struct Terminated {
        std::uint64_t domain = 0;     ///< left the domain
        std::uint64_t time = 0;       ///< came to the end of their time
        std::uint64_t obstacle = 0;   ///< met an obstacle
        std::uint64_t stagnation = 0; ///< came to rest
        std::uint64_t budget = 0;     ///< took too many steps

        /// Counts one more.
        void add(CurveEnd end) {
            domain += end == CurveEnd::Domain;
            time += end == CurveEnd::Time;
            obstacle += end == CurveEnd::Obstacle;
            stagnation += end == CurveEnd::Stagnation;
            budget += end == CurveEnd::Budget;
        }
    };

    /// Wall-clock times, in seconds.
    struct Seconds {
        double load = 0;   ///< waiting for time-steps
        double advect = 0; ///< carrying particles
        double refine = 0; ///< changing the mesh
        double other = 0;  ///< what is none of these
        double total = 0;  ///< all of it
    };

    SurfaceKind kind = SurfaceKind::Stream; ///< as it was asked for
    std::uint64_t quads = 0;                ///< cells
    std::uint64_t vertices = 0;             ///< those that hang too
    std::uint64_t steps = 0;                ///< integrator steps of the longest column
    std::uint64_t vertex_steps = 0;         ///< integrator steps of all columns
    std::uint64_t approximated = 0;         ///< vertices that are interpolated
    Terminated terminated;                  ///< what ended its particles
    /// The range of a level surface's field at that time.
    std::optional<std::array<double, 2>> field_range{};
    /// Cells of a streak or time surface that were deleted among living particles, until then: these diverged
    /// or converged so much that no cells between them can follow.
    std::optional<std::uint64_t> torn{};
    double max_edge = 0;                ///< length of the longest edge there is
    double separation = 0;              ///< longest edge allowed in the end
    double requested_separation = 0;    ///< the one asked for
    Seconds seconds;                    ///< what it took
    std::optional<StatedError> error{}; ///< nothing: none was estimated
    /// Nothing: not estimated, for the reason in interval_left_out.
    std::optional<StatedIntervalError> interval_error{};
    /// The stored interval at which 99 % of the vertices would be within the separation; nothing where that
    /// cannot be said.
    std::optional<double> advised_interval{};
    std::optional<StatedTwin> twin{}; ///< nothing: not compared, for the reason in twin_left_out
    std::string twin_left_out{};      ///< why there is no twin; empty: nobody asked for it
    std::string interval_left_out{}; ///< why there is no interval_error; empty: nobody asked for it
    /// The time at which the data begin, if that cuts the backward side of a path surface of both directions
    /// short.
    std::optional<double> data_end{};

    /// The quad budget did not allow the separation asked for.
    bool coarsened() const { return separation > requested_separation; }

    std::optional<Emptiness> empty{}; ///< why there is nothing to see, where that is so
    std::string stopped{}; ///< why the surface ends before the time asked for; usually empty
};

} // namespace wakesurf::core
