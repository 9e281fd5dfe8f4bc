// A stream surface as truth: columns so dense and so exact (tolerance 1e-11) that a distance to it is the
// other surface's error. Columns are cut at equal arc lengths; where neighbours are farther than a third of a
// cell apart, the seed between them is traced as well.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/rake.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::bench {

class DenseReference {
  public:
    struct Extent {
        double time = 0.0; ///< integration time: columns go at least as far as particles in it,
        double arc = 0.0;  ///< and at least this far
    };

    /// Traces the field as it is at `release`. Runs on all cores.
    DenseReference(const core::Flow& flow, const core::Rake& rake, double release, Extent extent);

    /// Returns the distance from a point to the triangles round the nearest vertex; infinite beyond eight
    /// cells.
    double distance(const core::Vec3& point) const;

    std::size_t columns() const { return columns_.size(); }

    std::size_t vertices() const { return nearby_.size(); }

  private:
    using Column = std::vector<core::Vec3>; ///< vertices at equal arc lengths

    struct Vertex {
        core::Vec3 position;
        std::uint32_t column, index;
    };

    std::vector<Column> trace(const core::Flow& flow,
                              const core::SeedingCurve& rake,
                              const std::vector<double>& seeds,
                              double release) const;
    void index_by_place();
    std::array<std::int64_t, 3> bin_of(const core::Vec3& point) const;
    double to_triangles_round(const Vertex& vertex, const core::Vec3& point) const;

    core::Box box_;
    double cell_;
    Extent extent_;
    std::vector<Column> columns_;
    std::array<std::int64_t, 3> bins_{};
    std::vector<std::uint32_t> first_; ///< of each bin, in `nearby_`
    std::vector<Vertex> nearby_;       ///< sorted by bin
};

} // namespace wakesurf::bench
