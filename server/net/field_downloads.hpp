// Files of a field's values over HTTP, as slice.bin and lines.bin: /api/v1/datasets/D/FILE?...&field=p&time=2.5. Each reader asks for what it
// shows, and takes back what it does not want any more by hanging up.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/field/sampled_field.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/net/http_message.hpp"
#include "server/net/shared_files.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Error: InvalidArgument, naming the parameter.
core::Result<double> read_field_time(const std::string& text, std::string_view name = "time");

/// Returns the time to sample at. Error: InvalidArgument where the flow has several and none is given.
core::Result<double> time_of(std::optional<double> asked, const LoadedDataset& dataset);

/// Sets the values of a field at a time apart from all others. @param id  of the dataset
std::string
values_tag(const std::string& id, const LoadedDataset& data, const std::string& field, double time);

/// What files are made of.
struct FieldSource {
    const DatasetCatalogue& catalogue;
    const core::MemoryAccount& account;
    std::string dataset; ///< its id
};

/// A field of a dataset at a time.
struct FieldAtTime {
    std::shared_ptr<const LoadedDataset> dataset; ///< keeps what the field needs
    core::SampledField field;
    std::string name; ///< of the field
    double time;
    std::string tag; ///< values_tag
};

/// @param field   empty: the velocity
/// @param normal  of the plane that shows it, which has the velocity across it; null: there is none. Error: NotFound, saying what there is; InvalidArgument where the flow has several times and none is
/// given.
core::Result<FieldAtTime> field_at(const std::string& field,
                                   std::optional<double> time,
                                   const FieldSource& source,
                                   const std::optional<core::Vec3>& normal = {});

/// A file that can be made.
struct FieldFile {
    std::string tag; ///< the same tag, the same bytes
    PriorityClass priority;
    SharedFiles::Make make;
};

/// Serves them. Loop thread only; the pool does the work. They are cached apart from other files, which a clock that plays or a plane that is
/// dragged would drive out.
class FieldDownloads {
  public:
    /// Error: whatever the query asks for in vain.
    using Plan = core::Result<FieldFile> (*)(const std::map<std::string, std::string>& query,
                                             const FieldSource& source);

    /// REQUIRES: all arguments outlive this.
    FieldDownloads(Loop& loop,
                   ComputePool& pool,
                   const DatasetCatalogue& catalogue,
                   const core::MemoryAccount& account)
        : catalogue_(catalogue), account_(account), files_(loop, pool, &account_) {}

    /// Answers a request. @param line  the key for taking turns in the pool
    void get(const HttpRequest& request,
             const std::string& line,
             const std::string& dataset,
             Plan plan,
             const Respond& respond);

  private:
    const DatasetCatalogue& catalogue_;
    const core::MemoryAccount& account_;
    SharedFiles files_;
};

} // namespace wakesurf::server
