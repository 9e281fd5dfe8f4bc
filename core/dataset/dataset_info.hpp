// Describes a dataset as `info --json` and `dataset.describe` tell it. It holds values only; their JSON text
// lives in protocol/api/dataset_json.hpp.
#pragma once

#include "core/base/periodic_axes.hpp"
#include "core/dataset/wall_geometry.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::core {

/// The unit of times that count the iterations of a steady solver: its last one is the result.
inline constexpr std::string_view iterations = "iterations";

enum class GridKind { Uniform, Rectilinear, Curvilinear, Unstructured, Analytic };

/// The precision of stored values at nodes; in memory they are float32.
enum class Precision : std::uint8_t { Single, Half };

/// Describes an array of a dataset.
struct FieldInfo {
    /// The place of values in the source.
    enum class Source { Point, Cell };
    std::string name;   ///< as the source calls it
    int components = 1; ///< numbers a node: 1 of a scalar, 3 of a vector
    /// The place of its values in the source; in memory they are at the nodes.
    Source source = Source::Point;
    std::array<double, 2> range{
        0.0, 0.0};       ///< over what has been read so far; of the magnitude for vectors
    std::string unit;    ///< empty where the format has none
    bool family = false; ///< made here, from the velocity: core/surface/family
    bool mean = false;   ///< made here, over time: core/dataset/mean_record.hpp
    /// False if an import leaves the array out, as it does masks, so that it cannot be requested.
    bool stored = true;

    /// Made here and kept beside the data, so that it can be made again.
    bool kept() const { return family || mean; }
};

/// The description of a dataset, without its values.
struct DatasetInfo {
    std::string dataset;               ///< id, stable between starts
    std::string name;                  ///< for people
    std::string reader;                ///< what read it: vtkXMLImageDataReader, store, analytic ...
    GridKind grid = GridKind::Uniform; ///< what kind of grid it has
    Box bounds;                        ///< round all nodes
    std::array<std::uint32_t, 3> dimensions{0, 0,
                                            0}; ///< nodes per axis of a uniform or rectilinear grid
    Vec3 spacing{0.0};                          ///< of a uniform grid
    std::uint64_t points = 0;                   ///< nodes
    std::uint64_t cells = 0;                    ///< as the source has them: polyhedra count once
    std::vector<double> times;                  ///< strictly increasing
    std::string length_unit;       ///< of coordinates, as the reader knows it; empty: unknown
    std::string time_unit;         ///< of times; empty: unknown
    bool steady = false;           ///< it has one field for all times
    std::vector<FieldInfo> fields; ///< scalars and vectors, the velocity among them
    std::string velocity;          ///< name of the field taken as velocity
    std::string why;               ///< why that field was taken
    std::string note; ///< what a user should know: cells left out, rounding; may be empty
    Precision precision = Precision::Single; ///< of the values on the disk
    bool obstacle = false;                   ///< parts of the domain are solid
    /// The parts of its boundary that the source names, in the order in which the walls are kept.
    std::vector<BoundaryPatch> patches{};
    PeriodicAxes periodic{};          ///< where particles go on through the sides of `bounds`
    std::uint64_t bytes_per_step = 0; ///< memory of a time-step's velocity

    /// The default separation distance, in units of length: the finest node spacing; for analytic flows 1/100
    /// of the shortest side.
    double finest_spacing = 0.0;
};

/// Returns the unit of a field by its name; empty where it has none, or there is no such field.
inline std::string unit_of(const DatasetInfo& info, std::string_view field) {
    for (const FieldInfo& each : info.fields)
        if (each.name == field)
            return each.unit;
    return {};
}

} // namespace wakesurf::core
