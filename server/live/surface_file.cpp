#include "server/live/surface_file.hpp"

#include "core/base/clock.hpp"
#include "core/base/work_memory.hpp"
#include "core/surface/builder/interval_errors.hpp"
#include "core/surface/builder/twin.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/patches/tessellation.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "protocol/files/mesh_file.hpp"
#include "protocol/files/surface_lines.hpp"
#include "server/base/sha256.hpp"
#include "server/data/surface_scalars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace wakesurf::server {

using core::Error;

protocol::Recipe recipe_of(const core::SurfacePlan& plan, RecipeData data) {
    return {.version = WAKESURF_VERSION,
            .dataset = std::move(data.dataset),
            .flow = std::move(data.flow),
            .values = std::move(data.values),
            .rake = plan.rake,
            .parameters = plan.parameters,
            .rounding = rounding_mark()};
}

protocol::Recipe recipe_of(const core::SurfacePlan& plan, const LoadedDataset& dataset) {
    return recipe_of(plan, RecipeData{dataset.info.dataset, dataset.flow_text, values_of(dataset)});
}

namespace {

std::uint64_t mixed(std::uint64_t so_far, std::uint64_t word) { // splitmix64
    std::uint64_t x = (so_far ^ word) + 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint64_t mixed(std::uint64_t so_far, double number) {
    return mixed(so_far, std::bit_cast<std::uint64_t>(number));
}

std::string rounding_here() {
    constexpr int samples = 200;             // of each function a few in a thousand round otherwise
    const volatile double unit = 1.0 / 16.1; // the compiler computes nothing of it
    std::uint64_t sum = 0;
    for (int k = 1; k <= samples; ++k) {
        const double x = k * unit;
        for (const double value :
             {std::sin(x), std::cos(x), std::tan(x), std::exp(-x), std::log(x), std::pow(x, 0.2),
              std::acos(x / 13), std::atan2(x, 3.0), std::cbrt(x), std::tanh(x / 4)})
            sum = mixed(sum, value);
    }
    return fmt::format("{:016x}", sum);
}

} // namespace

const std::string& rounding_mark() {
    static const std::string here = rounding_here();
    return here;
}

std::string shape_mark(const core::QuadComplex& mesh) {
    std::vector<std::uint64_t> vertex(mesh.vertices());
    for (std::size_t v = 0; v < vertex.size(); ++v)
        for (const double number :
             {mesh.position[v].x, mesh.position[v].y, mesh.position[v].z, mesh.s[v], mesh.t[v]})
            vertex[v] = mixed(vertex[v], number);
    std::uint64_t one = mesh.cells.size();
    std::uint64_t other = mesh.vertices();
    for (const core::Cell& cell : mesh.cells) {
        std::uint64_t sum = 0;
        for (const auto& four : {cell.corner, cell.mid})
            for (const core::VertexId v : four)
                sum = mixed(sum, v == core::no_vertex ? std::uint64_t{1} : vertex[v]);
        one += sum;
        other += mixed(sum, std::uint64_t{2});
    }
    return fmt::format("{:016x}{:016x}", one, other);
}

namespace {

template <class Value>
void add_array(Sha256& sum, const std::vector<Value>& values) {
    const std::uint64_t count = values.size();
    sum.add(std::as_bytes(std::span(&count, 1)));
    sum.add(std::as_bytes(std::span(values)));
}

} // namespace

std::string mesh_digest(const core::QuadComplex& mesh, const protocol::MeshScalars& scalars) {
    Sha256 sum;
    add_array(sum, mesh.position);
    add_array(sum, mesh.s);
    add_array(sum, mesh.t);
    add_array(sum, mesh.velocity);
    add_array(sum, mesh.deformation);
    add_array(sum, mesh.component);
    add_array(sum, mesh.approximated);
    add_array(sum, mesh.error);
    add_array(sum, mesh.interval_error);
    add_array(sum, mesh.normal);
    add_array(sum, mesh.cells);
    for (const auto& [name, values] : scalars) {
        sum.add(name);
        add_array(sum, values);
    }
    return digest_text(sum.digest());
}

namespace {

core::Result<std::string> bytes_of(const protocol::Recipe& recipe,
                                   const core::QuadComplex& mesh,
                                   const protocol::MeshMetadata& metadata,
                                   const protocol::MeshScalars& scalars) {
    const auto format = protocol::mesh_format(recipe.format);
    if (!format)
        return core::fail(Error::Code::InvalidArgument,
                          "there is no format ." + recipe.format.substr(0, 16));
    std::optional<protocol::LinesWanted> lines;
    if (!recipe.lines.empty()) {
        const auto read = protocol::read_lines(recipe.lines, recipe.parameters.kind, *format);
        if (!read)
            return tl::unexpected(read.error());
        lines = *read;
    }
    const bool points = lines && lines->form == protocol::LinesWanted::Form::Points;
    if (lines && !points)
        return protocol::surface_lines(mesh, *lines, recipe.rake.closed())
            .and_then([&](const auto& found) {
                return protocol::lines_file(*format, found, *lines, metadata);
            });
    return protocol::mesh_file(
        *format, mesh, metadata, scalars,
        recipe.draco ? protocol::GlbCoding::Draco : protocol::GlbCoding::Plain,
        points ? protocol::PlyElements::Points : protocol::PlyElements::Cells);
}

std::string digest_of(std::string_view file) {
    Sha256 sum;
    sum.add(file);
    return digest_text(sum.digest());
}

} // namespace

void seal(std::string& file) {
    const auto found = protocol::find_recipes(file).sound;
    if (!found.empty())
        file.replace(found.front().seal_begin(), protocol::seal_length, digest_of(file));
}

bool seal_holds(std::string file, const protocol::FoundRecipe& recipe) {
    file.replace(recipe.seal_begin(), protocol::seal_length, protocol::seal_length, '0');
    return digest_of(file) == recipe.seal;
}

core::Result<SurfaceFile> surface_file(protocol::Recipe recipe,
                                       const core::QuadComplex& mesh,
                                       const core::SurfaceStatistics& statistics,
                                       const protocol::MeshScalars& scalars,
                                       const std::string& text) {
    recipe.mesh = mesh_digest(mesh, scalars);
    const protocol::MeshMetadata metadata{
        .rake = recipe.rake,
        .parameters = recipe.parameters,
        .separation = statistics.separation,
        .tessellate = recipe.tessellate,
        .dataset = recipe.dataset,
        .version = recipe.version,
        .time = recipe.time,
        .stopped = recipe.coarse ? "this is the coarse surface that was shown before the final one"
                                 : statistics.stopped,
        .errors = protocol::stated_errors(statistics),
        .recipe = text.empty() ? protocol::recipe_text(recipe) : text};
    return bytes_of(recipe, mesh, metadata, scalars).map([&](std::string&& bytes) {
        seal(bytes);
        return SurfaceFile{std::move(bytes), recipe.mesh};
    });
}

namespace {

/// The memory for making a file from a mesh, in bytes a vertex: the most of all formats, Draco's, measured as
/// the peak beside a mesh of 380,000 vertices.
constexpr std::size_t vertex_file_bytes = 560;

/// Returns a step of a series as write_series makes it.
core::Result<core::SurfaceAt> step_at(const core::SurfacePlan& plan,
                                      double time,
                                      const std::stop_token& stop,
                                      core::WorkPart work) {
    const core::SteadyClock clock;
    auto evolution = core::Evolution::start(plan, clock, stop, work);
    if (!evolution)
        return tl::unexpected(evolution.error());
    return evolution->at(time, stop, work).map([&](core::Evolution::State&& state) {
        return core::SurfaceAt{std::move(state.mesh.mesh), std::move(state.statistics),
                               std::move(state.times)};
    });
}

/// Returns the fields of the twin that are asked for; none where it cannot be compared. Vertices of cut cells have none.
core::Result<protocol::MeshScalars> twin_scalars(const protocol::Recipe& recipe,
                                                 const core::SurfacePlan& plan,
                                                 const LoadedDataset& dataset,
                                                 const core::Surface& surface,
                                                 const core::SurfacePlan* twin,
                                                 const std::stop_token& stop,
                                                 const core::WorkPart& work) {
    protocol::MeshScalars out;
    if ((twin == nullptr && !recipe.twin) || recipe.coarse || recipe.tessellate > 1 ||
        std::ranges::none_of(recipe.fields, core::is_twin_name))
        return out;
    const auto planned = twin != nullptr ? core::Result<core::SurfacePlan>(*twin)
                                         : core::plan_twin(plan, dataset.flow, *recipe.twin);
    const auto compared = planned.and_then([&](const core::SurfacePlan& other) {
        return core::compare_twin(plan, surface, other, stop, work);
    });
    if (!compared && compared.error().code != Error::Code::InvalidArgument)
        return tl::unexpected(compared.error());
    for (const std::string& name : recipe.fields)
        if (compared && core::is_twin_name(name))
            out[name] = name == core::twin_lag_name ? compared->lag : compared->distance;
    return out;
}

core::Result<void> take(std::size_t bytes, const std::stop_token& stop, const FileMemory& memory) {
    if (memory.share->grow_to(bytes, stop, memory.patience))
        return {};
    if (stop.stop_requested())
        return core::fail(Error::Code::Cancelled, "the client that asked for the file has left");
    return tl::unexpected(memory.account->refusal("a file of this surface", bytes));
}

} // namespace

core::Result<SurfaceFile> make_surface_file(const protocol::Recipe& recipe,
                                            const core::SurfacePlan& plan,
                                            const LoadedDataset& dataset,
                                            const std::stop_token& stop,
                                            const FileMemory& memory,
                                            const std::string& text,
                                            const core::SurfacePlan* twin) {
    core::WorkMemory work(*memory.account, stop, memory.patience, "a file of this surface");
    const core::WorkPart part{nullptr, &work};
    auto shown = recipe.step && recipe.time
                     ? step_at(plan, *recipe.time, stop, part)
                     : core::surface_at(plan, recipe.time, core::SteadyClock{}, stop, part);
    if (!shown)
        return tl::unexpected(shown.error());
    core::Surface whole{std::move(shown->mesh), std::move(shown->statistics), shown->ended};
    if (!recipe.coarse && !recipe.step) // where they cannot be estimated, the file is without
        static_cast<void>(core::state_interval_errors(plan, whole, stop, part));
    auto scalars = twin_scalars(recipe, plan, dataset, whole, twin, stop, part);
    if (!scalars)
        return tl::unexpected(scalars.error());
    if (recipe.tessellate > 1) {
        auto cut = core::tessellate(plan, whole.mesh, shown->times, recipe.tessellate, stop, part);
        if (!cut)
            return tl::unexpected(cut.error());
        whole.mesh = std::move(cut->mesh);
        whole.statistics.error = core::stated_error(whole.mesh, whole.statistics.separation);
    }
    const std::size_t needed =
        whole.mesh.vertices() * (vertex_file_bytes + 8 * recipe.fields.size());
    if (auto taken = take(needed, stop, memory); !taken)
        return tl::unexpected(taken.error());
    std::vector<std::string> others = recipe.fields;
    std::erase_if(others, core::is_twin_name);
    auto sampled = surface_scalars(dataset, whole.mesh, shown->times, others, stop);
    if (!sampled)
        return tl::unexpected(sampled.error());
    scalars->merge(*sampled);
    return surface_file(recipe, whole.mesh, whole.statistics, *scalars, text);
}

} // namespace wakesurf::server
