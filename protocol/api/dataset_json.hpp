// A dataset's description <-> JSON: the one shape of `info --json`, `dataset.describe` and a store's
// manifest.
#pragma once

#include "core/dataset/dataset_info.hpp"
#include "core/dataset/mean_record.hpp"
#include "core/surface/family/family_record.hpp"
#include "protocol/api/base/json_members.hpp"

namespace wakesurf::protocol {

template <>
inline constexpr auto words_of<core::GridKind> = std::to_array<Word<core::GridKind>>({
    {core::GridKind::Uniform, "uniform"},
    {core::GridKind::Rectilinear, "rectilinear"},
    {core::GridKind::Curvilinear, "curvilinear"},
    {core::GridKind::Unstructured, "unstructured"},
    {core::GridKind::Analytic, "analytic"},
});

template <>
inline constexpr auto words_of<core::Precision> = std::to_array<Word<core::Precision>>(
    {{core::Precision::Single, "single"}, {core::Precision::Half, "half"}});

template <class Io>
void members(Io& io, Of<Io, core::DatasetInfo>& of);

/// A mean over time: the one shape of `mean.make`, `dataset.describe` and what is kept beside the data.
template <class Io>
void members(Io& io, Of<Io, core::MeanRecord>& of);

/// A family of stream surfaces: the one shape of `family.make`, `dataset.describe` and what is kept beside the
/// data.
template <class Io>
void members(Io& io, Of<Io, core::FamilyRecord>& of);

} // namespace wakesurf::protocol
