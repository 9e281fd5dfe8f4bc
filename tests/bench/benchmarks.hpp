// The benchmarks `wakesurf-bench` knows. Each registers itself with Google Benchmark under a name that says
// what is measured; targets are printed beside the figures as counters named `target_ms`.
#pragma once

#include "server/data/open_dataset.hpp"

#include <memory>
#include <string>

namespace wakesurf::bench {

/// Surfaces of every kind in every closed form and in a dataset: exact, balanced and fast beside each other,
/// in quads and in time.
void register_accuracy_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset);

/// The shape of streak and time surfaces in every closed form and in a dataset: slivers, angles, specks and
/// holes.
void register_shape_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset);

/// Bytes and times of the updates of moving surfaces, beside raw floats and whole Draco meshes.
void register_wire_benchmarks(std::shared_ptr<const server::LoadedDataset> dataset);

/// From a rake edit at the socket of a server process to the first frame of the new surface.
void register_edit_benchmark(const std::string& dataset);

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

/// A streak surface on its way past a body, in meshes of cells.
void register_cells_benchmarks();

/// Adaptive stream surfaces against vtkStreamSurface at equal longest edge and equal area: time, growth.
void register_stream_surface_benchmarks();

/// How far flat and tessellated cells are from the exact surface, on closed forms and on data.
void register_tessellation_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset);

/// The error between stored times as predicted, beside the true one, on closed forms.
void register_interval_error_benchmarks();

/// What is left of that error with other interpolation between stored times, and what this costs.
void register_between_benchmarks();

/// 30 level sets of one field, one after the other, each to its frames.
void register_level_benchmark();

/// 30 slices of one field, as a plane is dragged: coarse, and at the resolution of a screen.
void register_slice_benchmark();

/// Single steps of a streak surface of 100,000 vertices: whole frames with refinement, on one thread and on
/// two.
void register_streak_frame_benchmarks();

/// A server in a control group of 512 MB beside tenants who take all they are granted, for so many seconds.
void register_hostile_benchmark(const std::string& dataset, int seconds);

/// A host who joins, edits and downloads beside one viewer's link at full force: 2,048 sockets, refused
/// edits, downloads in a loop.
void register_flood_benchmark(const std::string& dataset);

} // namespace wakesurf::bench
