// Reading a time-step of 300 MB from a store whose files are in the page cache, beside a plain read() of the same bytes.
#include "core/base/clock.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/temporary_store.hpp"

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace wakesurf::bench {

namespace store_bench {

constexpr std::size_t steps = 3;
constexpr int rounds = 9;
constexpr double target_part_of_plain_read = 0.8;

const TemporaryStore& store() {
    static const TemporaryStore made(
        {"abc", {core::Vec3(0.0), core::Vec3(0.01), {500, 500, 100}}, {0.0, 1.0, 2.0}});
    return made;
}

/// read() of a whole file into memory that has been used before.
void plain_read(const std::string& file, std::span<std::byte> out) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    std::size_t got = 0;
    while (got < out.size()) {
        const auto count = ::read(descriptor, out.data() + got, out.size() - got);
        if (count <= 0)
            throw std::runtime_error("cannot read " + file);
        got += static_cast<std::size_t>(count);
    }
    ::close(descriptor);
}

void load(const store::StoreReader& reader, std::size_t index) {
    const auto step = reader.load(index, {});
    if (!step)
        throw std::runtime_error(step.error().message);
    benchmark::DoNotOptimize((*step)->velocity().data());
}

/// @param first  every load is by a reader that has not read the file before, and so checks it
void measure(benchmark::State& state, core::Precision precision, bool first) {
    const auto open = [&] {
        return precision == core::Precision::Half ? store().half_reader() : store().reader();
    };
    auto reader = open();
    const auto file = [&](std::size_t index) {
        return reader->layout().folder /
               store::step_file_name(store::velocity_stem, index, precision);
    };
    const auto bytes = store::step_file_size(core::node_count(reader->grid()), 3, precision);
    core::Slab slab(bytes);
    for (std::size_t i = 0; i < steps; ++i)
        load(*reader, i);
    std::size_t next = 0;
    std::size_t next_plain = 0;
    const Turn ours = [&] {
        if (first) {
            reader = store().reader();
            load(*reader, (next + 1) % steps); // another time-step, whose memory is used again
        }
        return seconds_of([&] { load(*reader, next++ % steps); });
    };
    const Turn plain = [&] {
        return seconds_of([&] { plain_read(file(next_plain++ % steps), slab.bytes()); });
    };
    const Turn plain_into_new = [&] {
        return seconds_of([&] {
            core::Slab fresh(bytes);
            plain_read(file(next_plain++ % steps), fresh.bytes());
        });
    };
    for (auto _ : state) {
        const auto taken = interleave({ours, plain, plain_into_new}, rounds);
        state.SetIterationTime(taken[0].median);
        state.counters["gigabytes_per_second"] =
            1e-9 * static_cast<double>(bytes) / taken[0].median;
        state.counters["part_of_plain_read"] = taken[1].median / taken[0].median;
        state.counters["part_of_plain_read_into_new_memory"] = taken[2].median / taken[0].median;
        if (!first && precision == core::Precision::Single)
            state.counters["target_part_of_plain_read"] = target_part_of_plain_read;
        state.counters["spread"] = taken[0].spread;
    }
}

} // namespace store_bench

void register_store_benchmarks() {
    using namespace store_bench;
    const auto add = [](const char* name, core::Precision precision, bool first) {
        benchmark::RegisterBenchmark(
            name, [=](benchmark::State& state) { measure(state, precision, first); })
            ->UseManualTime()
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    };
    add("store/read_again", core::Precision::Single, false);
    add("store/read_first_and_check", core::Precision::Single, true);
    add("store/read_again_half", core::Precision::Half, false);
}

} // namespace wakesurf::bench
