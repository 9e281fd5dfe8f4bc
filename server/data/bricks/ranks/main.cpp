// wakesurf-bricks: ranks of an MPI job that hold the bricks of a store in their memory, for a server whose
// disk is too slow. The server starts it (`wakesurf serve --bricks`) and outlives it.
#include "core/base/machine_memory.hpp"
#include "server/data/bricks/ranks/asked_bricks.hpp"
#include "store/command/manual_page.hpp"
#include "store/command/memory_size.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <chrono>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

using namespace wakesurf;

constexpr unsigned ending_patience = 10; // s
constexpr std::chrono::microseconds idle_look{50};

constexpr const char* chapters = R"(.SH SEE ALSO
\fBwakesurf\fR(1), \fBmpirun\fR(1), \fBsrun\fR(1)
)";

struct Wish {
    std::string store, socket;
    std::uint64_t memory = 0;
};

int say(const core::Error& error) {
    std::fprintf(stderr, "wakesurf-bricks: %s%s%s\n", error.message.c_str(),
                 error.hint.empty() ? "" : "; ", error.hint.c_str());
    return 1;
}

/// Returns a quarter of the node's memory, divided by its ranks: the server may run there as well.
std::uint64_t usual_memory() {
    MPI_Comm node = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    int ranks = 1;
    MPI_Comm_size(node, &ranks);
    MPI_Comm_free(&node);
    return core::granted_memory() / 4 / static_cast<std::uint64_t>(ranks);
}

/// Serves the server until it has gone.
core::Result<void>
talk(const Wish& wish, const server::RankStore& store, server::BrickWindow& window) {
    auto asked = server::AskedBricks::meet(wish.socket, store, window);
    if (!asked)
        return tl::unexpected(asked.error());
    bool more = true;
    while (asked->look(!more))
        more = more && window.load_next();
    ::alarm(ending_patience); // a rank that hangs does not block the others
    asked->finish();
    return {};
}

/// Keeps this rank answering. A rank answers only inside MPI, unless the network does it alone: it calls MPI
/// often, and yields the processor in between.
void hold(server::BrickWindow& window, MPI_Request& end) {
    bool more = true;
    for (int over = 0; over == 0;) {
        MPI_Test(&end, &over, MPI_STATUS_IGNORE);
        more = more && window.load_next();
        if (!more && over == 0)
            std::this_thread::sleep_for(idle_look);
    }
}

/// Open MPI 4 prefers RDMA for windows also between nodes with TCP alone, where it cannot make one, and ends
/// the job. Its other ways can. Settings of mpirun or the environment stay.
void choose_windows() {
#if defined(OMPI_MAJOR_VERSION) && OMPI_MAJOR_VERSION < 5
    ::setenv("OMPI_MCA_osc", "^rdma", 0);
#endif
}

int run(const Wish& wish) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const auto store = server::RankStore::open(wish.store);
    int mine = store ? 1 : 0, all = 0;
    MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (!store)
        return say(store.error());
    if (all == 0)
        return 1; // another rank has reported the error
    if (server::brick_record_bytes((*store)->shape().values) > INT_MAX) {
        return rank == 0 ? say({core::Error::Code::OverLimit, "a brick has more than 2 GiB", ""})
                         : 1;
    }
    const std::uint64_t usual = usual_memory();
    server::BrickWindow window(**store, wish.memory > 0 ? wish.memory : usual);
    MPI_Request end = MPI_REQUEST_NULL;
    core::Result<void> talked;
    if (rank == 0) {
        talked = talk(wish, **store, window);
        ::alarm(ending_patience);
        MPI_Ibarrier(MPI_COMM_WORLD, &end);
        MPI_Wait(&end, MPI_STATUS_IGNORE);
    } else {
        MPI_Ibarrier(MPI_COMM_WORLD, &end);
        hold(window, end);
        ::alarm(ending_patience);
    }
    return talked ? 0 : say(talked.error());
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Holds the bricks of a store in the memory of the ranks of an MPI job, for `wakesurf "
        "serve --bricks \"mpirun -n N\"`, which starts it.",
        "wakesurf-bricks");
    Wish wish;
    app.add_option("STORE", wish.store, "a store in bricks, which every rank can read")->required();
    app.add_option("--socket", wish.socket, "where the server waits for rank 0")->required();
    app.add_option("--memory", wish.memory,
                   "bytes of each rank for bricks, for example 64GiB (default: a quarter of its "
                   "node's memory, shared by the ranks there)")
        ->transform(command::as_memory_size());
    app.set_version_flag("--version", "wakesurf-bricks " WAKESURF_VERSION);
    app.add_flag_callback("--man-page",
                          [&] {
                              throw CLI::CallForVersion(
                                  command::manual_page(app, {WAKESURF_VERSION, chapters}), 0);
                          })
        ->group("");
    CLI11_PARSE(app, argc, argv);
    choose_windows();
    MPI_Init(&argc, &argv);
    const int status = run(wish);
    MPI_Finalize();
    return status;
}
