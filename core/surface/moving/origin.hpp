// Where the material points of a moving surface come from: a rake that releases over time (streak), or a
// patch released at once (time); and the first mesh: the rake's first row of attached vertices, or the whole
// patch. The inverse of advection: (s, t) can be traced again. Source: McLoughlin, Laramee, Zhang, SCCG 2010.
#pragma once

#include "core/base/result.hpp"
#include "core/field/flow.hpp"
#include "core/surface/moving/moving_mesh.hpp"
#include "core/surface/rake.hpp"

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

class Origin {
  public:
    /// Makes the origin of a streak surface, whose t is the release time.
    explicit Origin(SeedingCurve rake, bool smooth = false);

    /// Makes the origin of a time surface: t in 0..1 runs from the rake to `opposite`, a second rake or the
    /// rake moved by a vector; all is released at `release`.
    Origin(SeedingCurve rake, SeedingCurve opposite, double release);
    Origin(SeedingCurve rake, const Vec3& sweep, double release);

    bool patch() const { return opposite_.has_value() || sweep_.has_value(); }

    bool closed() const;

    Vec3 position(double s, double t) const;

    double release(double t) const { return patch() ? release_ : t; }

    /// Returns the longest of 17 ways across a patch at constant s.
    double longest_across() const;

    /// Returns the length of the seeding curve; of a patch the longer of its two.
    double length() const;

    /// Seed parameters that must be vertices: where the curve has corners.
    std::vector<double> corners() const;

    /// Returns position, tangents and area at release of every (s, t). `along_t` of a streak is minus the
    /// velocity there then. Error: what sampling reports.
    Result<std::vector<MaterialPoint>> points(const Flow& flow,
                                              std::span<const double> s,
                                              std::span<const double> t,
                                              std::stop_token stop) const;

  private:
    SeedingCurve curve_;
    std::optional<SeedingCurve> opposite_;
    std::optional<Vec3> sweep_;
    double release_ = 0.0;
    bool smooth_ = false;
};

/// Traces vertices again from where they were released to the mesh's time, in steps of controlled error; they
/// are no longer approximated, and dead if they do not arrive. Error: what advancing reports.
Result<void> retrace(MovingMesh& mesh,
                     const Origin& origin,
                     const Flow& flow,
                     std::span<const VertexId> vertices,
                     AdvanceOptions options,
                     std::stop_token stop);

/// The seed parameters of the columns that a surface begins with.
struct Columns {
    std::vector<double> s;
    double count = 0.0; ///< intervals
    bool closed = false;

    /// Returns the number of the column with a seed parameter, a fraction between two of them.
    double column(double seed) const;
};

/// Returns columns evenly spaced between the curve's corners.
Columns make_columns(const Origin& origin, double intervals);

/// Attaches a vertex for each seed parameter at the mesh's time, in their order. Error: what sampling reports.
Result<std::vector<VertexId>> attach_row(MovingMesh& mesh,
                                         const Origin& origin,
                                         const Flow& flow,
                                         std::span<const double> seeds,
                                         std::stop_token stop);

/// Seed parameters of a row: columns, and every half, quarter ... between one inside and one outside an obstacle down to
/// `finest`.
std::vector<double>
row_seeds(const Origin& origin, const Flow& flow, const Columns& columns, double finest);

/// Joins an older row with the newer one behind it. Both in order along the rake; cells come where two
/// neighbours of the older row, no more than a column apart, have neighbours of the same seeds in the newer one.
void join_rows(MovingMesh& mesh,
               const Columns& columns,
               std::span<const VertexId> newer,
               std::span<const VertexId> older);

/// Lays the whole patch of a time surface as free vertices and cells. Error: what sampling reports.
Result<void> lay_patch(MovingMesh& mesh,
                       const Origin& origin,
                       const Flow& flow,
                       const Columns& columns,
                       double rows,
                       std::stop_token stop);

} // namespace wakesurf::core
