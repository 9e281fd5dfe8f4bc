// A store in bricks holds what the same store of whole time-steps holds.
#include "core/base/crc32c.hpp"
#include "store/brick_slabs.hpp"
#include "tests/support/brick_store.hpp"
#include "tests/support/mask_bytes.hpp"
#include "tests/support/read_bricks.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <random>

namespace wakesurf::store::bricks_test {

namespace {

using namespace core;

using namespace tests;

core::Grid grid_of(const std::array<std::uint32_t, 3>& dimensions, bool uniform) {
    if (uniform)
        return UniformGrid{{0, 0, 0}, {1, 1, 1}, dimensions};
    RectilinearGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i < dimensions[axis]; ++i)
            grid.coordinates[axis].push_back(i * (1.0 + 0.1 * i));
    return grid;
}

/// Values with gaps here and there, and an obstacle.
StoreValues
random_values(std::mt19937& random, const core::Grid& grid, Precision precision, bool gaps) {
    StoreValues what{grid, precision, {}, {}};
    const std::size_t nodes = node_count(grid);
    std::uniform_real_distribution<float> value(-100.0F, 100.0F);
    for (std::size_t step = 0; step < 2; ++step) {
        auto& columns = what.values.emplace_back();
        for (std::size_t column = 0; column < 2; ++column) {
            auto& values = columns.emplace_back(nodes * components_of(column));
            for (float& each : values)
                each = value(random);
            if (gaps && step == 1)
                values[random() % values.size()] = std::numeric_limits<float>::quiet_NaN();
        }
    }
    const std::size_t solid_from = random() % nodes;
    for (std::size_t node = 0; node < nodes; ++node)
        what.fluid.push_back(node < solid_from || node > solid_from + nodes / 3 ? 1 : 0);
    return what;
}

bool same_bits(std::span<const std::byte> a, std::span<const std::byte> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size()) == 0;
}

void expect_same(const StoreReader& whole, const StoreReader& bricks) {
    const std::size_t nodes = core::node_count(whole.grid());
    EXPECT_EQ(mask_bytes(whole.mask(), nodes), mask_bytes(bricks.mask(), nodes));
    EXPECT_EQ(whole.bytes_per_step(), bricks.bytes_per_step());
    for (std::size_t step = 0; step < 2; ++step) {
        ASSERT_TRUE(bricks.whole(step));
        const auto a = whole.load(step, {});
        const auto b = bricks.load(step, {});
        ASSERT_TRUE(a && b) << b.error().message;
        EXPECT_EQ((*a)->gaps, (*b)->gaps);
        EXPECT_TRUE(same_bits((*a)->slab.bytes(), (*b)->slab.bytes())) << step;
        const auto s = whole.load_scalar(0, step, {});
        const auto t = bricks.load_scalar(0, step, {});
        ASSERT_TRUE(s && t) << t.error().message;
        EXPECT_TRUE(same_bits(s->bytes(), t->bytes())) << step;
    }
}

/// Every node of every brick against the time-step it is of; nodes beyond the grid against the last ones.
void expect_bricks_of(const StoreReader& store, std::size_t column, std::size_t step) {
    const BrickSource& source = *store.bricks();
    const auto& layout = source.layout();
    const std::size_t components = components_of(column);
    std::vector<std::vector<float>> bricks(
        layout.count(), std::vector<float>(layout.nodes_per_brick() * components));
    std::vector<BrickRead> reads;
    for (std::size_t brick = 0; brick < layout.count(); ++brick)
        reads.push_back({step, brick, bricks[brick], column});
    for (const auto& outcome : outcomes_of(source, reads))
        ASSERT_TRUE(outcome) << outcome.error().message;
    const Slab all = column == 0 ? Slab() : store.load_scalar(column - 1, step, {}).value();
    const auto loaded = store.load(step, {}).value();
    const auto bytes = column == 0 ? loaded->slab.bytes() : all.bytes();
    const auto* values = reinterpret_cast<const float*>(bytes.data());
    const auto& nodes = layout.brick_nodes();
    const auto& grid = layout.dimensions();
    for (std::size_t brick = 0; brick < layout.count(); ++brick) {
        const auto first = layout.first_node(brick);
        for (std::size_t node = 0; node < layout.nodes_per_brick(); ++node) {
            const std::array<std::size_t, 3> in{node % nodes[0], node / nodes[0] % nodes[1],
                                                node / nodes[0] / nodes[1]};
            std::size_t flat = 0;
            for (const std::size_t axis : {2u, 1u, 0u})
                flat = flat * grid[axis] +
                       std::min<std::size_t>(first[axis] + in[axis], grid[axis] - 1);
            for (std::size_t c = 0; c < components; ++c)
                ASSERT_EQ(std::bit_cast<std::uint32_t>(bricks[brick][components * node + c]),
                          std::bit_cast<std::uint32_t>(values[components * flat + c]))
                    << "brick " << brick << " node " << node;
        }
    }
}

} // namespace

TEST(Bricks, HoldWhatTheSameStoreOfWholeTimeStepsHolds) {
    std::mt19937 random(1);
    // Bricks of 4 cells: grids thinner than a brick, of a whole number of bricks, and of one node more or less.
    const std::array<std::uint32_t, 8> sizes{2, 3, 4, 5, 6, 8, 9, 10};
    for (int round = 0; round < 40; ++round) {
        const auto size = [&] { return sizes[random() % sizes.size()]; };
        const std::array<std::uint32_t, 3> dimensions{size(), size(), size()};
        const auto precision = random() % 2 == 0 ? Precision::Half : Precision::Single;
        const auto what = random_values(random, grid_of(dimensions, random() % 2 == 0), precision,
                                        random() % 2 == 0);
        SCOPED_TRACE(testing::Message() << "round " << round << ": " << dimensions[0] << " x "
                                        << dimensions[1] << " x " << dimensions[2]);
        const TemporaryFolder whole;
        const TemporaryFolder bricks;
        const auto flat = open_bricks(write_store(whole / "store", what, 0));
        const auto paged = open_bricks(write_store(bricks / "store", what, 4, 1 + random() % 200));
        EXPECT_EQ(flat->bricks(), nullptr);
        ASSERT_NE(paged->bricks(), nullptr);
        expect_same(*flat, *paged);
        for (std::size_t step = 0; step < 2; ++step) {
            EXPECT_EQ(paged->bricks()->gaps(step), paged->load(step, {}).value()->gaps);
            for (std::size_t column = 0; column < 2; ++column)
                expect_bricks_of(*paged, column, step);
        }
    }
}

TEST(Bricks, LieInTheirFileAsTheFormatSays) {
    std::mt19937 random(2);
    const auto what = random_values(random, grid_of({70, 35, 40}, true), Precision::Single, false);
    const TemporaryFolder folder;
    const auto layout = write_store(folder / "store", what, 32);
    const auto bricks = layout.bricks();
    const std::string values = read_file(folder / "store/velocity_000001.f32");
    const std::string sums = read_file(folder / "store/velocity_000001.bricks");
    const std::size_t bytes = 33 * 33 * 33 * 12;
    ASSERT_EQ(values.size(), bricks.count() * bytes);
    ASSERT_EQ(sums.size(), bricks.count() * 5);
    EXPECT_EQ(checksum_of(sums), open_bricks(layout)->marks().checksum(1, 0));
    for (std::size_t place = 0; place < bricks.count(); ++place) {
        const auto brick = std::string_view(values).substr(place * bytes, bytes);
        std::uint32_t sum = 0;
        std::memcpy(&sum, sums.data() + 4 * place, 4);
        EXPECT_EQ(sum, checksum_of(brick)) << place;
        const auto first = bricks.first_node(bricks.brick_on_disk(place));
        const std::size_t node = first[0] + 70 * (first[1] + 35 * first[2]);
        EXPECT_EQ(0, std::memcmp(brick.data(), &what.values[1][0][3 * node], 12)) << place;
    }
}

TEST(Bricks, AreMadeOfPiecesOfAnySize) {
    const BrickLayout layout({6, 5, 9}, 4);
    std::vector<std::byte> nodes(6 * 5 * 9 * 2);
    std::mt19937 random(3);
    for (auto& byte : nodes)
        byte = static_cast<std::byte>(random());
    const auto cut = [&](std::size_t piece) {
        std::vector<std::vector<std::byte>> bricks(layout.count());
        BrickSlabs slabs(layout, 2, [&](std::size_t place, std::span<const std::byte> brick) {
            EXPECT_TRUE(bricks.at(place).empty()) << "put twice";
            bricks[place].assign(brick.begin(), brick.end());
            return Result<void>();
        });
        for (std::size_t at = 0; at < nodes.size(); at += piece) {
            EXPECT_FALSE(slabs.complete());
            EXPECT_TRUE(
                slabs.add(std::span(nodes).subspan(at, std::min(piece, nodes.size() - at))));
        }
        EXPECT_TRUE(slabs.complete());
        return bricks;
    };
    const auto whole = cut(nodes.size());
    for (const std::size_t piece : {1u, 7u, 12u, 60u, 61u})
        EXPECT_EQ(cut(piece), whole) << piece;
    BrickSlabs full(layout, 2, [](std::size_t, auto) { return Result<void>(); });
    ASSERT_TRUE(full.add(nodes));
    EXPECT_THROW(static_cast<void>(full.add(std::span(nodes).first(1))), std::logic_error);
}

TEST(Bricks, EndWithTheErrorOfWhoGivesTheValuesAndLeaveNoFile) {
    const TemporaryFolder folder;
    auto writer = StoreWriter::open(folder / "store", [] { return Result<void>(); }).value();
    StoreLayout layout;
    layout.grid = stored_grid(UniformGrid{{0, 0, 0}, {1, 1, 1}, {9, 9, 9}});
    layout.times = {0.0};
    layout.brick_cells = 4;
    const std::vector<float> layers(3 * 81 * 6);
    int calls = 0;
    const auto written =
        write_values(writer, layout, 0, 0, [&]() -> Result<std::span<const float>> {
            if (++calls == 2)
                return fail(Error::Code::Cancelled, "enough");
            return std::span<const float>(layers);
        });
    EXPECT_EQ(written.error().message, "enough");
    for (const auto& entry : std::filesystem::directory_iterator(folder / "store"))
        EXPECT_NE(entry.path().filename().string().substr(0, 8), "velocity") << entry.path();
    EXPECT_THROW(static_cast<void>(write_values(writer, layout, 0, 0, std::span(layers))),
                 std::logic_error);
}

} // namespace wakesurf::store::bricks_test
