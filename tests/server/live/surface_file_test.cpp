// Files are made again from their recipes alone: random requests over flows, a store, kinds, formats and what else a file can hold.
#include "core/surface/level/level_surface.hpp"
#include "protocol/files/file_difference.hpp"
#include "protocol/files/mesh_file.hpp"
#include "server/live/surface_file.hpp"
#include "store/store_generation.hpp"
#include "tests/support/small_mesh.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>

namespace wakesurf::server::surface_file_test {

namespace {

using core::SurfaceKind;

core::Result<SurfaceFile> made(const protocol::Recipe& recipe,
                               const core::SurfacePlan& plan,
                               const LoadedDataset& dataset,
                               int threads = 2,
                               const std::string& text = {}) {
    const core::MemoryAccount account(std::size_t{1} << 30);
    auto share = account.open(core::MemoryUse::Downloads);
    tbb::task_arena arena(threads);
    return arena.execute([&] {
        return make_surface_file(recipe, plan, dataset, {},
                                 {&account, &share, std::chrono::seconds(1)}, text);
    });
}

LoadedDataset flow(const std::string& text) {
    DatasetArgument argument;
    argument.kind = DatasetArgument::Kind::Flow;
    argument.flow = text;
    return open_flow(argument).value();
}

/// The tornado, sampled at eleven times.
LoadedDataset stored(const std::filesystem::path& folder) {
    store::GenerateRequest request{
        .flow = "tornado", .grid = {{0, 0, 0}, {1.0 / 15, 1.0 / 15, 1.0 / 15}, {16, 16, 16}}};
    for (int k = 0; k <= 10; ++k)
        request.times.push_back(k);
    EXPECT_TRUE(store::generate_store(request, folder, [](const store::ImportProgress&) {}, {}));
    return open_store(folder, {{std::size_t{64} << 20, 1}}).value();
}

/// A request, and the data that it is for.
struct Wish {
    const LoadedDataset* dataset;
    core::SurfacePlan plan;
    protocol::Recipe recipe;
};

/// Draws requests: the same ones each time.
class Wishes {
  public:
    explicit Wishes(const std::filesystem::path& folder)
        : datasets_{flow("lamb-oseen"), flow("abc?C=0.5"), flow("double-gyre"), flow("cylinder"),
                    stored(folder)} {}

    Wish next() {
        while (true) {
            const LoadedDataset& dataset = datasets_[below(datasets_.size())];
            auto plan = core::plan_surface(dataset.flow, rake_in(dataset.flow->domain()),
                                           parameters_for(dataset));
            if (!plan || !core::take_levels(*plan, dataset.levels))
                continue;
            protocol::Recipe recipe = recipe_of(*plan, dataset);
            recipe.format =
                protocol::extension(protocol::mesh_formats[below(protocol::mesh_formats.size())]);
            recipe.draco = below(2) == 0;
            recipe.fields = fields_[below(fields_.size())];
            if (below(4) == 0 && plan->parameters.tangents)
                recipe.tessellate = 2;
            if (below(4) == 0 && plan->parameters.kind != SurfaceKind::Time &&
                recipe.format != "drc")
                recipe.lines = "timelines:3";
            const core::SurfaceParameters& p = plan->parameters;
            if (const auto choice = below(3); choice > 0) {
                recipe.time = p.from + (p.to - p.from) * within(0.3, 1.0);
                recipe.step = choice == 2;
            }
            return {&dataset, *std::move(plan), std::move(recipe)};
        }
    }

    std::size_t below(std::size_t limit) { return random_() % limit; }

  private:
    double within(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() % 1000) / 999.0;
    }

    core::Vec3 point_in(const core::Box& box) {
        const auto along = [&](int axis) {
            const double middle = 0.5 * (box.lo[axis] + box.hi[axis]);
            const double half = std::min(2.0, 0.5 * box.extent()[axis]);
            return middle + half * within(-1.1, 1.1); // some lie outside, and are clipped
        };
        return {along(0), along(1), along(2)};
    }

    core::Rake rake_in(const core::Box& box) {
        const auto kind = std::array{core::Rake::Kind::Line, core::Rake::Kind::Polyline,
                                     core::Rake::Kind::Circle}[below(3)];
        core::Rake rake{
            kind, {point_in(box), point_in(box)}, static_cast<std::uint32_t>(4 + below(20))};
        if (kind != core::Rake::Kind::Line)
            rake.points.push_back(point_in(box));
        return rake;
    }

    core::SurfaceParameters parameters_for(const LoadedDataset& dataset) {
        core::SurfaceParameters p;
        p.kind = std::array{SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak,
                            SurfaceKind::Time}[below(4)];
        const double first = within(0.0, 4.0);
        const double last = within(5.0, 9.0);
        const bool backward = below(3) == 0;
        p.from = backward ? last : first;
        p.to = backward ? first : last;
        if (below(4) == 0 && p.kind == SurfaceKind::Stream)
            p.direction = core::Direction::Both;
        const core::Vec3 size = dataset.flow->domain().extent();
        p.separation = within(0.02, 0.1) * std::max({size.x, size.y, size.z});
        p.accuracy = std::array{core::Accuracy::Fast, core::Accuracy::Balanced,
                                core::Accuracy::Exact}[below(3)];
        p.between =
            std::array{core::Between::Linear, core::Between::Cubic, core::Between::Flow}[below(3)];
        if (below(3) == 0 && dataset.store && p.between == core::Between::Linear)
            p.interpolation = core::Interpolation::Smooth;
        p.refine = below(5) == 0 ? core::Refine::Off : core::Refine::On;
        p.angle = within(5.0, 180.0);
        p.merge = within(0.0, 0.5);
        p.max_quads = std::array<std::uint64_t, 2>{3000, 200'000}[below(2)];
        p.deformation = true;
        p.tangents = below(2) == 0;
        if (p.kind == SurfaceKind::Time)
            p.sweep = core::Vec3(within(0.1, 0.5), within(0.1, 0.5), within(0.1, 0.5));
        if (p.kind == SurfaceKind::Streak && below(2) == 0)
            p.release_until = p.from + 0.6 * (p.to - p.from);
        if (p.kind != SurfaceKind::Stream && below(3) == 0)
            p.life = within(0.5, 3.0);
        return p;
    }

    std::mt19937 random_{20261129};
    std::array<LoadedDataset, 5> datasets_;
    std::array<std::vector<std::string>, 4> fields_{
        {{}, {"vorticity"}, {"velocity_x", "q_criterion"}, {"normal_z"}}};
};

} // namespace

TEST(SurfaceFile, IsMadeAgainFromItsRecipeAloneForFiftyRandomRequests) {
    const tests::TemporaryFolder folder;
    Wishes wishes(folder / "store");
    for (int done = 0, tried = 0; done < 50; ++tried) {
        ASSERT_LT(tried, 500);
        const Wish wish = wishes.next();
        const auto file = made(wish.recipe, wish.plan, *wish.dataset);
        if (!file) // nothing to see, or no such lines on it
            continue;
        ++done;
        const auto all = protocol::find_recipes(file->bytes);
        ASSERT_EQ(all.sound.size(), 1u);
        const protocol::FoundRecipe& found = all.sound.front();
        const std::string what = found.recipe.dataset + " ." + found.recipe.format;
        auto plan =
            core::plan_surface(wish.dataset->flow, found.recipe.rake, found.recipe.parameters);
        ASSERT_TRUE(plan) << what << plan.error().message;
        const auto again = made(found.recipe, *plan, *wish.dataset, 1, found.text);
        ASSERT_TRUE(again) << what;
        EXPECT_EQ(again->bytes, file->bytes) << what;
        EXPECT_EQ(again->mesh, found.recipe.mesh) << what;
        for (int k = 0; k < 20; ++k) {
            std::string other = file->bytes;
            const std::size_t at = wishes.below(other.size());
            other[at] = static_cast<char>(other[at] ^ (1 << wishes.below(8)));
            const auto difference =
                protocol::first_difference(found.recipe.format, other, again->bytes);
            EXPECT_TRUE(!difference.what.empty() || difference.recompressed) << what << at;
        }
    }
}

TEST(SurfaceFile, HasASealThatIsTheDigestOfTheFileWithoutIt) {
    const LoadedDataset dataset = flow("lamb-oseen");
    const auto plan =
        core::plan_surface(dataset.flow, {core::Rake::Kind::Line, {{0.2, 0, -1}, {1, 0, -1}}, 9},
                           {.kind = SurfaceKind::Path, .from = 0, .to = 2, .separation = 0.2});
    protocol::Recipe recipe = recipe_of(*plan, dataset);
    for (const protocol::MeshFormat format : protocol::mesh_formats) {
        recipe.format = protocol::extension(format);
        const auto file = made(recipe, *plan, dataset);
        const auto found = protocol::find_recipes(file->bytes).sound.front();
        EXPECT_TRUE(seal_holds(file->bytes, found)) << recipe.format;
        for (const std::size_t at :
             {std::size_t{0}, file->bytes.size() / 2, file->bytes.size() - 1}) {
            std::string other = file->bytes;
            other[at] ^= 1;
            EXPECT_FALSE(seal_holds(other, found)) << recipe.format << at;
        }
    }
}

TEST(SurfaceFile, ChangesItsDigestWithEveryValueOfTheSurface) {
    core::QuadComplex mesh = tests::small_mesh();
    const std::string before = mesh_digest(mesh, {{"p", {1}}});
    EXPECT_EQ(before.size(), 64u);
    mesh.position[3].y = std::nextafter(mesh.position[3].y, 2.0);
    const std::string moved = mesh_digest(mesh, {{"p", {1}}});
    mesh.cells[1].mid[0] = 5;
    const std::string joined = mesh_digest(mesh, {{"p", {1}}});
    const std::set<std::string> all{before,
                                    moved,
                                    joined,
                                    mesh_digest(mesh, {{"p", {2}}}),
                                    mesh_digest(mesh, {{"q", {2}}}),
                                    mesh_digest(mesh, {})};
    EXPECT_EQ(all.size(), 6u);
}

TEST(SurfaceFile, HasAMarkOfItsShapeThatIsTheSameInAnyOrderOfVerticesAndCells) {
    const core::QuadComplex mesh = tests::small_mesh();
    core::QuadComplex turned = mesh; // vertex v becomes 7 - v
    const auto other = [](core::VertexId v) { return v == core::no_vertex ? v : 7 - v; };
    for (core::VertexId v = 0; v < 8; ++v) {
        turned.position[other(v)] = mesh.position[v];
        turned.s[other(v)] = mesh.s[v];
        turned.t[other(v)] = mesh.t[v];
    }
    for (core::Cell& cell : turned.cells)
        for (std::size_t i = 0; i < 4; ++i) {
            cell.corner[i] = other(cell.corner[i]);
            cell.mid[i] = other(cell.mid[i]);
        }
    std::swap(turned.cells[0], turned.cells[2]);
    EXPECT_EQ(shape_mark(turned), shape_mark(mesh));
    turned.position[3].x += 1e-15;
    EXPECT_NE(shape_mark(turned), shape_mark(mesh));
    core::QuadComplex torn = mesh;
    torn.cells.pop_back();
    EXPECT_NE(shape_mark(torn), shape_mark(mesh));
}

} // namespace wakesurf::server::surface_file_test
