#include "protocol/api/dataset_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using core::DatasetInfo;
using core::FieldInfo;
using nlohmann::json;

template <>
inline constexpr auto words_of<FieldInfo::Source> = std::to_array<Word<FieldInfo::Source>>(
    {{FieldInfo::Source::Cell, "cell"}, {FieldInfo::Source::Point, "point"}});

template <>
inline constexpr auto table_of<FieldInfo> = std::tuple(needed("name", &FieldInfo::name),
                                                       needed("components", &FieldInfo::components),
                                                       needed("source", &FieldInfo::source),
                                                       needed("range", &FieldInfo::range),
                                                       some("unit", &FieldInfo::unit),
                                                       some("family", &FieldInfo::family),
                                                       some("stored", &FieldInfo::stored));

template <>
inline constexpr auto
    table_of<DatasetInfo> = std::tuple(needed("dataset", &DatasetInfo::dataset),
                                       needed("name", &DatasetInfo::name),
                                       needed("reader", &DatasetInfo::reader),
                                       needed("grid", &DatasetInfo::grid),
                                       needed("bounds", &DatasetInfo::bounds),
                                       needed("points", &DatasetInfo::points),
                                       needed("cells", &DatasetInfo::cells),
                                       needed("times", &DatasetInfo::times),
                                       needed("steady", &DatasetInfo::steady),
                                       needed("fields", &DatasetInfo::fields),
                                       needed("velocity", &DatasetInfo::velocity),
                                       needed("why", &DatasetInfo::why),
                                       needed("obstacle", &DatasetInfo::obstacle),
                                       needed("bytesPerStep", &DatasetInfo::bytes_per_step),
                                       newer("finestSpacing", &DatasetInfo::finest_spacing),
                                       some("periodic", &DatasetInfo::periodic),
                                       some("note", &DatasetInfo::note),
                                       some("lengthUnit", &DatasetInfo::length_unit),
                                       some("timeUnit", &DatasetInfo::time_unit),
                                       some("precision", &DatasetInfo::precision),
                                       some("dimensions", &DatasetInfo::dimensions),
                                       some("spacing", &DatasetInfo::spacing));

json dataset_json(const DatasetInfo& info) {
    return written<json>(info);
}

core::Result<DatasetInfo> parse_dataset_info(const json& value) {
    return parse_table<DatasetInfo>(value);
}

} // namespace wakesurf::protocol
