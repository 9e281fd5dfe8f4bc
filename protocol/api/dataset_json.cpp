#include "protocol/api/dataset_json.hpp"

#include "protocol/api/generated/names.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using core::DatasetInfo;
using core::FamilyRecord;
using core::FieldInfo;

template <class Io>
void members(Io& io, Of<Io, core::FamilyStep>& of) {
    io.needed("index", of.index);
    io.needed("time", of.time);
    io.needed("nodes", of.counts.nodes);
    io.needed("reached", of.counts.reached);
    io.needed("atRest", of.counts.at_rest);
    io.needed("obstacle", of.counts.obstacle);
    io.needed("lost", of.counts.lost);
    io.needed("outside", of.counts.outside);
    io.needed("range", of.counts.range);
}

template <class Io>
void members(Io& io, Of<Io, FamilyRecord>& of) {
    io.needed("name", of.name);
    io.needed("version", of.version);
    io.needed("steps", of.steps);
    io.needed("accuracy", of.request.accuracy);
    io.needed("length", of.request.length);
    auto& source = of.request.source;
    constexpr std::array<const char*, 3> words{"inflow", "plane", "curve"};
    std::string from = words[source.index()];
    io.needed("from", from,
              {.hi = 256, .text = Text::Line, .choices = {"inflow", "plane", "curve"}});
    if constexpr (Io::reads) {
        if (from == "plane")
            source.template emplace<core::FamilyPlane>();
        if (from == "curve")
            source.template emplace<core::Rake>();
    }
    if (auto* plane = std::get_if<core::FamilyPlane>(&source)) {
        io.needed("point", plane->point);
        io.needed("normal", plane->normal);
    }
    if (auto* rake = std::get_if<core::Rake>(&source)) {
        io.needed("rakeKind", rake->kind);
        io.needed("points", rake->points);
    } else {
        io.needed("scalar", of.request.scalar);
    }
    io.check("steps", of.steps.empty() ? "must not be empty" : "");
}

template void members(JsonReader&, FamilyRecord&);
template void members(JsonWriter&, const FamilyRecord&);

template <class Io>
void members(Io& io, Of<Io, core::MeanField>& of) {
    io.needed("name", of.name);
    io.needed("range", of.range);
}

template <class Io>
void members(Io& io, Of<Io, core::MeanRecord>& of) {
    io.needed("of", of.of);
    io.some("label", of.label);
    io.needed("from", of.from);
    io.needed("to", of.to);
    io.needed("steps", of.steps);
    io.some("period", of.period);
    io.some("phases", of.phases);
    io.needed("version", of.version);
    io.needed("fields", of.fields);
    io.check("fields", of.fields.empty() ? "must not be empty" : "");
}

template void members(JsonReader&, core::MeanRecord&);
template void members(JsonWriter&, const core::MeanRecord&);

template <>
inline constexpr auto words_of<FieldInfo::Source> = std::to_array<Word<FieldInfo::Source>>(
    {{FieldInfo::Source::Cell, "cell"}, {FieldInfo::Source::Point, "point"}});

template <class Io>
void members(Io& io, Of<Io, FieldInfo>& of) {
    io.needed("name", of.name);
    io.needed("components", of.components);
    io.needed("source", of.source);
    io.needed("range", of.range);
    io.some("unit", of.unit);
    io.some("family", of.family);
    io.some("mean", of.mean);
    io.some("stored", of.stored, {}, true);
}

template <>
inline constexpr auto words_of<core::BoundaryPatch::Kind> =
    std::to_array<Word<core::BoundaryPatch::Kind>>({{core::BoundaryPatch::Kind::Wall, "wall"},
                                                    {core::BoundaryPatch::Kind::Side, "side"},
                                                    {core::BoundaryPatch::Kind::Other, "other"}});

template <class Io>
void members(Io& io, Of<Io, core::BoundaryPatch>& of) {
    io.needed("name", of.name);
    io.needed("kind", of.kind);
    io.needed("triangles", of.triangles);
}

template <class Io>
void members(Io& io, Of<Io, DatasetInfo>& of) {
    io.needed("dataset", of.dataset);
    io.needed("name", of.name);
    io.needed("reader", of.reader);
    io.needed("grid", of.grid);
    io.needed("bounds", of.bounds);
    io.needed("points", of.points);
    io.needed("cells", of.cells);
    io.needed("times", of.times);
    io.needed("steady", of.steady);
    io.needed("fields", of.fields);
    io.needed("velocity", of.velocity);
    io.needed("why", of.why);
    io.needed("obstacle", of.obstacle);
    io.some("patches", of.patches);
    io.needed("bytesPerStep", of.bytes_per_step);
    io.newer("finestSpacing", of.finest_spacing);
    io.some("periodic", of.periodic);
    io.some("note", of.note);
    io.some("lengthUnit", of.length_unit);
    io.some("timeUnit", of.time_unit);
    io.some("precision", of.precision);
    io.some("dimensions", of.dimensions);
    io.some("spacing", of.spacing);
}

template void members(JsonReader&, DatasetInfo&);
template void members(JsonWriter&, const DatasetInfo&);

} // namespace wakesurf::protocol
