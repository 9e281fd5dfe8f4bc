// The benchmarks `wakesurf-bench` knows. Each registers itself with Google Benchmark under a name that says
// what is measured; targets are printed beside the figures as counters named `target_ms`.
#pragma once

#include "server/service/catalogue/open_dataset.hpp"

#include <memory>
#include <string>

namespace wakesurf::bench {

/// Surfaces of every kind in every closed form and in a dataset: exact, balanced and fast beside each other,
/// in quads and in time.
void register_accuracy_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset);

/// The shape of streak and time surfaces in every closed form and in a dataset: slivers, angles, specks and
/// holes.
void register_shape_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset);

/// The cost of coarsening to a quad budget, and the part of the budget that the surface then uses.
void register_budget_benchmarks();

/// Stream and path surfaces of about 20,000 quads on four rakes across the domain, complete, on one core.
void register_surface_benchmarks(std::shared_ptr<const server::LoadedDataset> dataset);

/// Bytes and times of the updates of moving and growing surfaces, beside raw floats and whole Draco meshes.
void register_wire_benchmarks(std::shared_ptr<const server::LoadedDataset> dataset);

/// From a rake edit at the socket of a server process to the first frame of the new surface.
void register_edit_benchmark(const std::string& dataset);

/// A drag at 60 Hz over a line with 100 ms of round trip.
void register_remote_drag_benchmark(const std::string& dataset);

/// Many clients of one session: viewers at 10 Hz, among them slow ones; all coming back at once; idle ones.
void register_load_benchmarks(const std::string& dataset);

/// A server killed under edits: what is lost, and how fast it is back.
void register_kill_benchmarks();

/// From a handle's move in Chromium to the drawn frame that shows its surface.
void register_drag_benchmark(const std::string& dataset);

/// Updates of a moving surface of 100,000 vertices, decoded by Chromium's worker.
void register_decode_benchmark();

/// Flow::advance on 30,000 particles, against a bare kernel (the machine's limit) and vtkStreaklineFilter.
void register_advection_benchmarks();
void register_sampling_benchmarks();

/// Time-steps in bricks beside whole ones, and time-steps larger than memory.
void register_bricks_benchmarks();

/// The first coarse surface of a store that is far away.
void register_disk_benchmarks();
void register_http_benchmarks();

/// Bricks from the memory of an MPI job's ranks beside files, and a surface after one of them was killed.
void register_ranks_benchmarks();

/// The scalar of a family of stream surfaces at the nodes of 128^3: nodes a second.
void register_family_benchmarks();

/// Velocity along paths through meshes of cells, and lookups at random, against vtkStaticCellLocator with its
/// cell cache.
void register_cells_benchmarks();

/// Adaptive stream surfaces against vtkStreamSurface at equal longest edge and equal area: time, growth,
/// deviation.
void register_stream_surface_benchmarks();

/// How far flat and tessellated cells are from the exact surface, on closed forms and on data.
void register_tessellation_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset);

/// 30 level sets of one field, one after the other, each to its frames.
void register_level_benchmark();

/// Single steps of a streak surface of 100,000 vertices: whole frames with refinement, on one thread and on
/// two.
void register_streak_frame_benchmarks();

/// A rake edit of a small surface to its first frame, alone and beside a session with 64 large surfaces being
/// dragged.
void register_fair_benchmark(const std::string& dataset);

/// A server in a control group of 512 MB beside tenants who take all they are granted, for so many seconds.
void register_hostile_benchmark(const std::string& dataset, int seconds);

/// A host who joins, edits and downloads beside one viewer's link at full force: 2,048 sockets, refused
/// edits, downloads in a loop.
void register_flood_benchmark(const std::string& dataset);

/// StoreReader::load of 300 MB time-steps against a plain read() of the same bytes.
void register_store_benchmarks();

/// An import of time-steps beside VTK's reader alone, which only reads them.
void register_import_benchmarks();

/// A streak surface through a series larger than the cache, against the same with all of it in memory.
void register_playing_benchmark();

} // namespace wakesurf::bench
