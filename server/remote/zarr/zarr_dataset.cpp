#include "server/remote/zarr/zarr_dataset.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/result.hpp"
#include "server/remote/zarr/zarr_axes.hpp"
#include "store/store_grid.hpp"
#include "store/velocity_names.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Names an array that has a value at each node.
struct ZarrField {
    const ZarrArray* array;
    ZarrAxes axes;
};

struct ZarrVelocity {
    std::vector<ZarrField> parts; ///< one vector, or three scalars
    std::string name;
    std::string why;
};

/// Returns the fields of a group.
std::vector<ZarrField> zarr_fields(const ZarrGroup& group);

/// Chooses a vector with the name of a velocity, else three arrays with the names of its components, else the
/// only vector. Error: NotFound, InvalidArgument (several velocities), Unsupported (staggered grids); that of
/// an unreadable array that would be chosen.
core::Result<ZarrVelocity> choose_zarr_velocity(const ZarrGroup& group,
                                                const std::vector<ZarrField>& fields);

using core::Error;
using core::fail;
using core::FieldInfo;
using core::Result;

namespace {

/// Returns the field's name; the root itself, if it is an array, has none.
std::string name_of(const ZarrField& field) {
    return field.array->name.empty() ? "velocity" : field.array->name;
}

FieldInfo scalar_named(const std::string& name) {
    return {name, 1, FieldInfo::Source::Point, {0.0, 0.0}, {}};
}

std::string listed(const ZarrGroup& group) {
    std::string out;
    for (const ZarrArray& array : group.arrays)
        out += (out.empty() ? "there is " : ", ") +
               (array.name.empty() ? "one array with " + std::to_string(array.shape.size()) +
                                         " axes, which is the root"
                                   : array.name);
    for (const auto& [name, error] : group.refused)
        out += (out.empty() ? "there is " : ", ") + name + " (" + error.message + ")";
    return out.empty() ? "it has no arrays" : out;
}

/// Returns the error of an unreadable array that would be the velocity, or a part of it: it says more than
/// that there is none.
std::optional<Error> refused_velocity(const ZarrGroup& group, std::vector<FieldInfo> scalars) {
    for (const auto& [name, error] : group.refused)
        scalars.push_back(scalar_named(name));
    const auto triples = store::velocity_components(scalars, FieldInfo::Source::Point);
    for (const auto& [name, error] : group.refused) {
        const auto is_it = [&name = name](const FieldInfo& part) { return part.name == name; };
        if (store::meaning_of_vector(name) == store::VectorName::Velocity ||
            (!triples.empty() && std::ranges::any_of(triples[0], is_it)))
            return Error{error.code, name + ": " + error.message, error.hint};
    }
    return std::nullopt;
}

} // namespace

std::vector<ZarrField> zarr_fields(const ZarrGroup& group) {
    std::vector<ZarrField> out;
    for (const ZarrArray& array : group.arrays)
        if (const auto axes = zarr_axes(array))
            out.push_back({&array, *axes});
    return out;
}

Result<ZarrVelocity> choose_zarr_velocity(const ZarrGroup& group,
                                          const std::vector<ZarrField>& fields) {
    std::vector<ZarrField> vectors;
    std::vector<ZarrField> named;
    std::vector<FieldInfo> scalars;
    for (const ZarrField& field : fields) {
        const auto meaning = store::meaning_of_vector(name_of(field));
        if (!field.axes.component)
            scalars.push_back(scalar_named(field.array->name));
        else if (meaning != store::VectorName::Other && meaning != store::VectorName::Momentum)
            vectors.push_back(field);
        if (field.axes.component && meaning == store::VectorName::Velocity)
            named.push_back(field);
    }
    const auto triples = store::velocity_components(scalars, FieldInfo::Source::Point);
    if (named.empty() && triples.empty())
        if (auto refused = refused_velocity(group, scalars))
            return tl::unexpected(std::move(*refused));
    if (named.empty() && triples.empty() && vectors.size() == 1)
        named = vectors;
    if (named.size() > 1 || (named.empty() && (triples.size() > 1 || vectors.size() > 1)))
        return fail(Error::Code::InvalidArgument, "it is not clear which array is the velocity",
                    listed(group) + "; put the velocity into a group of its own");
    if (named.size() == 1)
        return ZarrVelocity{named, name_of(named[0]),
                            vectors.size() == 1 ? "the only array with three components"
                                                : "the only vector with the name of a velocity"};
    if (triples.empty())
        return fail(
            Error::Code::NotFound,
            "the Zarr has no velocity: neither arrays u, v and w of the axes (time, z, y, x), "
            "nor one with an axis of three components",
            listed(group));
    ZarrVelocity out{{}, {}, "three arrays with the names of its components"};
    for (const FieldInfo& part : triples[0]) {
        const auto found =
            std::ranges::find(fields, part.name, [](const ZarrField& f) { return f.array->name; });
        out.parts.push_back(*found);
        out.name += (out.name.empty() ? "" : ", ") + part.name;
        if (found->array->shape != out.parts[0].array->shape ||
            found->array->dimensions != out.parts[0].array->dimensions)
            return fail(Error::Code::Unsupported,
                        out.parts[0].array->name + " and " + part.name +
                            " are on different nodes, as of a staggered grid",
                        "interpolate the velocity to common nodes first");
    }
    return out;
}

using core::Error;
using core::fail;
using core::FieldInfo;
using core::Result;

namespace {

constexpr std::size_t most_scalars = 256;

FieldInfo field_info(const std::string& name, int components, const std::string& unit) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {name, components, FieldInfo::Source::Point, {unknown, unknown}, unit};
}

bool is_one_of(const std::string& text, std::initializer_list<const char*> list) {
    return std::ranges::find(list, text) != list.end();
}

/// Refuses units that do not fit: metres a second along hours would be 3600 times too slow.
Result<void> check_units(const ZarrArray& velocity, const ZarrCoordinates& at) {
    const std::string& unit = velocity.unit;
    const bool metres_a_second = is_one_of(unit, {"m s-1", "m/s", "m s^-1", "m s**-1", "m.s-1"});
    const auto refused = [&](const std::string& what, const std::string& other) {
        return fail(Error::Code::Unsupported,
                    what + " are in " + other + ", but the velocity is in " + unit,
                    "write " + what + " in the unit that the velocity uses");
    };
    if (metres_a_second && !at.time_unit.empty() &&
        !is_one_of(at.time_unit, {"s", "sec", "secs", "second", "seconds"}))
        return refused("times", at.time_unit);
    if (metres_a_second && !at.length_unit.empty() &&
        !is_one_of(at.length_unit, {"m", "metre", "metres", "meter", "meters"}))
        return refused("coordinates", at.length_unit);
    return {};
}

bool same_nodes(const ZarrField& a, const ZarrField& b) {
    return a.axes.nodes(*a.array) == b.axes.nodes(*b.array) &&
           a.axes.steps(*a.array) == b.axes.steps(*b.array);
}

class Description {
  public:
    Description(const std::string& name, const ZarrGroup& group) : group_(group) {
        auto& info = out_.manifest.info;
        info.dataset = info.name = name;
        info.reader = "Zarr, version " + std::to_string(group.version);
        out_.manifest.complete = true;
    }

    Result<ZarrDataset> run(const ChunkObjects& objects, std::uint64_t scalar_bytes) {
        const auto fields = zarr_fields(group_);
        const auto choice = choose_zarr_velocity(group_, fields);
        if (!choice)
            return tl::unexpected(choice.error());
        const ZarrField& first = choice->parts[0];
        auto at = zarr_coordinates(group_, *first.array, first.axes, objects);
        if (!at)
            return tl::unexpected(at.error());
        if (auto fit = check_units(*first.array, *at); !fit)
            return tl::unexpected(fit.error());
        take_grid(std::move(*at));
        if (auto sound = store::check_layout(out_.manifest.layout); !sound)
            return tl::unexpected(sound.error());
        take_velocity(*choice);
        take_scalars(*choice, fields, scalar_bytes);
        store::mark_stored(out_.manifest.layout, out_.manifest.info);
        return std::move(out_);
    }

  private:
    void note(const std::string& text) {
        auto& note = out_.manifest.info.note;
        if (!text.empty())
            note += (note.empty() ? "" : "; ") + text;
    }

    void take_grid(ZarrCoordinates at) {
        auto& layout = out_.manifest.layout;
        auto& info = out_.manifest.info;
        layout.grid = store::stored_grid(at.grid);
        layout.times = info.times = std::move(at.times);
        layout.brick_cells = core::BrickLayout::usual_cells;
        layout.checked = false;
        for (const store::GridFile& file : store::grid_files(at.grid))
            layout.checksums[file.name] = core::crc32c(file.bytes);
        info.grid = layout.grid.kind;
        info.bounds = core::bounds(at.grid);
        info.dimensions = info.grid == core::GridKind::Uniform ? layout.grid.uniform.dimensions
                                                               : layout.grid.dimensions;
        if (info.grid == core::GridKind::Uniform)
            info.spacing = layout.grid.uniform.spacing;
        info.finest_spacing = core::finest_spacing(at.grid);
        info.points = layout.grid.nodes();
        info.cells = core::cell_count(at.grid);
        info.length_unit = at.length_unit;
        info.time_unit = at.time_unit;
        info.steady = info.times.size() == 1;
        info.bytes_per_step = store::step_file_size(info.points, 3, core::Precision::Single);
        note(at.note);
        out_.grid = std::move(at.grid);
    }

    std::size_t take(const ZarrField& field) {
        out_.arrays.push_back(*field.array);
        out_.axes.push_back(field.axes);
        return out_.arrays.size() - 1;
    }

    void take_velocity(const ZarrVelocity& choice) {
        auto& info = out_.manifest.info;
        std::vector<ZarrPart> parts;
        for (const ZarrField& field : choice.parts) {
            const std::size_t array = take(field);
            for (std::uint64_t c = 0; c < (field.axes.component ? 3u : 1u); ++c)
                parts.push_back({array, c});
            out_.manifest.layout.may_have_gaps |= field.array->may_miss_values();
        }
        out_.columns.push_back(std::move(parts));
        info.velocity = choice.name;
        info.why = choice.why;
        info.fields.push_back(field_info(choice.name, 3, choice.parts[0].array->unit));
    }

    void take_scalars(const ZarrVelocity& choice,
                      const std::vector<ZarrField>& fields,
                      std::uint64_t scalar_bytes) {
        const auto is_part = [&](const ZarrArray& array) {
            return std::ranges::any_of(choice.parts,
                                       [&](const ZarrField& part) { return part.array == &array; });
        };
        std::vector<ZarrField> scalars;
        std::string left_out;
        const auto leave = [&](const std::string& name, const std::string& why) {
            left_out += (left_out.empty() ? "" : ", ") + name + " (" + why + ")";
        };
        for (const ZarrArray& array : group_.arrays) {
            const auto found = std::ranges::find(fields, &array, &ZarrField::array);
            if (is_part(array) || array.shape.size() < 2)
                continue;
            if (found == fields.end() || !same_nodes(*found, choice.parts[0]))
                leave(array.name, "on other nodes");
            else if (found->axes.component)
                leave(array.name, "a second vector");
            else if (scalars.size() == most_scalars)
                leave(array.name, "more than " + std::to_string(most_scalars) + " scalars");
            else
                scalars.push_back(*found);
        }
        for (const auto& [name, error] : group_.refused)
            leave(name, error.message);
        const auto& info = out_.manifest.info;
        const std::uint64_t kept = std::min<std::uint64_t>(4, scalars.size()) *
                                   std::min<std::uint64_t>(2, info.times.size());
        for (const ZarrField& field : scalars)
            if (info.points * sizeof(float) > scalar_bytes / kept)
                leave(field.array->name, "there is not enough memory for scalars");
            else
                take_scalar(field);
        if (!left_out.empty())
            note("left out: " + left_out);
        if (!group_.listed)
            note("the arrays of the group cannot be listed: without consolidated metadata, only "
                 "the usual names of a velocity were tried");
    }

    void take_scalar(const ZarrField& field) {
        auto& scalars = out_.manifest.layout.scalars;
        scalars.push_back({field.array->name, "scalar-" + std::to_string(scalars.size())});
        out_.columns.push_back({{take(field), 0}});
        out_.manifest.info.fields.push_back(field_info(field.array->name, 1, field.array->unit));
    }

    const ZarrGroup& group_;
    ZarrDataset out_;
};

} // namespace

Result<ZarrDataset> describe_zarr(const std::string& name,
                                  const ZarrGroup& group,
                                  const ChunkObjects& objects,
                                  std::uint64_t scalar_bytes) {
    return Description(name, group).run(objects, scalar_bytes);
}

} // namespace wakesurf::server
