// The parameters of a surface: those of `wakesurf surface` and `surface.set`.
#pragma once

#include "core/field/between_times.hpp"
#include "core/surface/rake.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::core {

enum class SurfaceKind { Stream, Path, Streak, Time, Level };
enum class Direction { Forward, Backward, Both };
enum class Accuracy { Fast, Balanced, Exact };

/// The interpolation of stored velocity between nodes and time-steps. Linear: by the shape functions of a
/// cell, linear in time, as ParaView shows it; every grid has it. Smooth: cubic in space and time, of a
/// uniform grid. Closed forms are not interpolated.
enum class Interpolation { Linear, Smooth };

/// The mesh either follows the surface or not. On: quads are cut, joined and reconnected, and torn at
/// obstacles. Off: the grid that the rake begins with stays as it is, as in von Funck, Weinkauf, Theisel,
/// Seidel, Smoke Surfaces, 2008; quads with a particle that has ended are left out.
enum class Refine { On, Off };

/// A request for a surface, as it was made.
struct SurfaceParameters {
    SurfaceKind kind = SurfaceKind::Stream; ///< which of the kinds
    /// The start time. Stream: time at which the field is frozen; else: the (first) release.
    double from = 0.0;
    /// The end time: before `from` if time runs backward. Stream: `to - from` is the integration time, and
    /// `to` need not lie in the data; else: shown until. Level: a steady field has one time, `from`.
    double to = 1.0;
    /// Empty if `from` and `to` determine it (direction_of); a contradiction is refused.
    std::optional<Direction> direction{};
    /// The longest edge allowed, in the dataset's length unit; 0: DatasetInfo::finest_spacing.
    double separation = 0.0;
    /// The accuracy of tracing and inserting, in the field as interpolated.
    Accuracy accuracy = Accuracy::Balanced;
    Interpolation interpolation = Interpolation::Linear; ///< of stored velocity
    /// Stored velocity between stored times. Smooth interpolation has its own, and goes with Linear only.
    Between between = Between::Linear;
    /// Lets cells merge where both of their sides are shorter than this part of the separation; 0: never.
    double merge = 0.35;
    /// Limits the angle between neighbouring cells, in degrees: cells that meet at more are refined, along
    /// the flow and across, those of stream and path surfaces down to an eighth of the separation; 180:
    /// never.
    double angle = 20.0;
    /// A part of the largest speed: a slower particle counts as at rest. It ends in stream surfaces and steady
    /// closed forms; elsewhere where a wall holds it, or else waits (at_rest.hpp). 0: only a particle that does not move at all. Default: such a particle moves 1/15 of a
    /// lattice step (domain / 65,536) while the fastest crosses the domain, which is invisible.
    double stagnation_speed = 1e-6;
    /// The refinement. With Off, `merge`, `angle` and `separation` across the flow are ignored.
    Refine refine = Refine::On;
    std::uint64_t max_quads = 1'000'000; ///< the separation gives way where more would be needed
    /// Computes the deformation array: that of stream and path surfaces takes time.
    bool deformation = false;
    /// Keeps dx/ds and dx/dt of each vertex, which takes the same time: what patches/ needs.
    bool tangents = false;
    /// Ends the release of a streak surface (a streak sheet); default: `to`.
    std::optional<double> release_until{};
    /// Ends a particle of a path, streak or time surface at this age; default: it lives to the end.
    std::optional<double> life{};
    std::optional<Rake> rake2{}; ///< time: the patch lies between the rake and this one
    std::optional<Vec3> sweep{}; ///< time: the patch is the rake swept along this vector

    std::optional<std::string> field{}; ///< level: the scalar field that it is a level set of
    std::optional<double> level{};      ///< level: the value that the field has on it

    bool operator==(const SurfaceParameters&) const = default;
};

/// What the twin of a surface (surface/builder/twin.hpp) has otherwise; what is left open is the same.
struct TwinSettings {
    std::optional<Accuracy> accuracy{};
    std::optional<Interpolation> interpolation{};
    std::optional<Between> between{};
    std::optional<Vec3> offset{}; ///< by which the rakes are moved

    bool operator==(const TwinSettings&) const = default;
};

} // namespace wakesurf::core
