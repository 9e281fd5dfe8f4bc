#include "importer/base/text.hpp"
#include "importer/sources/blocks/block_roles.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/exodus/exodus_file.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/series/series_times.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;
namespace fs = std::filesystem;

namespace {

class ExodusSource final : public Source {
  public:
    ExodusSource(ExodusSet set, std::string velocity) : velocity_(std::move(velocity)) {
        description_.name = set.name;
        description_.reader = "vtkExodusIIReader (Exodus II";
        if (set.parts.front().size() > 1)
            description_.reader += ", " + std::to_string(set.parts.front().size()) + " pieces";
        description_.reader += ")";
        description_.note = set.note;
        for (auto& pieces : set.parts) {
            auto& files = restarts_.emplace_back();
            for (auto& piece : pieces)
                files.emplace_back(std::move(piece));
        }
    }

    core::Result<void> open() {
        std::vector<TimedEntry> entries;
        for (std::size_t i = 0; i < restarts_.size(); ++i)
            if (auto added = add_steps(i, entries); !added) {
                if (i == 0 || !ends_series(added.error()))
                    return added;
                steps_.push_back({i, 0});
                entries.push_back({restarts_[i].front().file().name, std::nullopt, added.error()});
            }
        const bool timeless = !entries.front().time;
        auto order = describe_times(std::move(entries), description_);
        if (!order)
            return tl::unexpected(order.error());
        keep_in_order(steps_, *order);
        if (timeless)
            description_.time_note = "the file has no times";
        auto first = load(0, nullptr);
        if (first && first->blocks.empty()) {
            plane_ = true;
            first = load(0, nullptr);
        }
        if (!first)
            return tl::unexpected(first.error());
        if (first->blocks.empty())
            return core::fail(Error::Code::Unsupported,
                              restarts_[steps_.front().restart].front().file().name +
                                  " has no block of elements in space or in a plane");
        for (const auto& name : restarts_[steps_.front().restart].front().displacements())
            add_note(description_.note, "the displacements " + name + " are not applied");
        BlockRoles roles = block_roles(first->blocks, velocity_);
        solid_ = std::move(roles.fluid);
        solid_.flip();
        description_.fields = std::move(roles.fields);
        add_note(description_.note, roles.note);
        return {};
    }

    core::Result<std::vector<store::SourceFile>> shared_files() const override {
        return several() ? core::Result<std::vector<store::SourceFile>>() : files_of(0);
    }

    core::Result<std::vector<store::SourceFile>> files(std::size_t step) const override {
        return several() ? files_of(steps_.at(step).restart)
                         : core::Result<std::vector<store::SourceFile>>();
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        auto out = load(step, &fields);
        if (!out)
            return out;
        auto blocks = std::exchange(out->blocks, {});
        const auto& [restart, in_file] = steps_.at(step);
        if (blocks.empty())
            return core::fail(Error::Code::Corrupt, restarts_[restart].front().step_name(in_file) +
                                                        " has no cells any more");
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            if (i < solid_.size() && solid_[i]) {
                out->solids.push_back(boundary_of(*blocks[i]));
                continue;
            }
            if (auto whole = require_fields(*blocks[i], fields,
                                            restarts_[restart].front().step_name(in_file));
                !whole)
                return tl::unexpected(whole.error());
            keep_only(*blocks[i], fields);
            out->blocks.push_back(std::move(blocks[i]));
        }
        return out;
    }

  private:
    struct Step {
        std::size_t restart;
        std::size_t in_file;
    };

    bool several() const { return restarts_.size() > 1; }

    core::Result<std::vector<store::SourceFile>> files_of(std::size_t restart) const {
        std::vector<NamedFile> files;
        for (const auto& piece : restarts_[restart])
            files.push_back(piece.file());
        return fingerprint(files);
    }

    // Adds the times that all pieces have: of a run that was killed some may have one more.
    core::Result<void> add_steps(std::size_t restart, std::vector<TimedEntry>& entries) {
        auto& pieces = restarts_[restart];
        std::vector<double> times;
        for (std::size_t p = 0; p < pieces.size(); ++p) {
            auto here = pieces[p].open();
            if (!here)
                return tl::unexpected(here.error());
            const auto common = p == 0 ? here->size() : std::min(times.size(), here->size());
            if (p > 0 && !std::equal(times.begin(), times.begin() + std::ptrdiff_t(common),
                                     here->begin(), same_time))
                return core::fail(Error::Code::Corrupt,
                                  pieces[p].file().name + " has different times from " +
                                      pieces.front().file().name,
                                  "they are not of one run");
            if (p > 0 && times.size() != here->size())
                add_note(description_.note, pieces[p].file().name + " has other than " +
                                                std::to_string(times.size()) +
                                                " times: those that all pieces have, " +
                                                std::to_string(common) + ", are read");
            if (p == 0)
                times = std::move(*here);
            times.resize(common);
            if (restart > 0)
                pieces[p].close();
        }
        for (std::size_t i = 0; i < times.size(); ++i) {
            steps_.push_back({restart, i});
            entries.push_back({pieces.front().step_name(i), times[i]});
        }
        if (times.empty() && !several()) {
            steps_.push_back({restart, 0});
            entries.push_back({pieces.front().step_name(0), std::nullopt});
        }
        if (entries.empty())
            return core::fail(Error::Code::Corrupt,
                              pieces.front().file().name + " has no time-steps");
        return {};
    }

    core::Result<SourceStep> load(std::size_t step, const std::vector<FieldInfo>* fields) {
        const auto& [restart, in_file] = steps_.at(step);
        if (restart != open_)
            for (auto& piece : restarts_[std::exchange(open_, restart)])
                piece.close();
        SourceStep out;
        for (auto& piece : restarts_[restart]) {
            auto part = piece.read(in_file, fields, plane_);
            if (!part)
                return part;
            std::ranges::move(part->blocks, std::back_inserter(out.blocks));
            std::ranges::move(part->walls, std::back_inserter(out.walls));
        }
        return out;
    }

    std::string velocity_;                          ///< asked for; may be empty
    std::vector<std::vector<ExodusFile>> restarts_; ///< the pieces of each
    std::size_t open_ = 0;                          ///< the restart whose files are open
    std::vector<Step> steps_;
    bool plane_ = false;      ///< no element is three-dimensional
    std::vector<bool> solid_; ///< of each block of elements: without the velocity
};

} // namespace

bool is_exodus(const fs::path& path) {
    constexpr std::array<const char*, 7> endings{".exo", ".exii", ".ex2",  ".e",
                                                 ".g",   ".gen",  ".exoii"};
    const ExodusName name = exodus_name(path.filename().string());
    const std::string ending = lower_extension(name.base);
    if (std::find(endings.begin(), endings.end(), ending) == endings.end())
        return false;
    // Plot3D calls its grids .g as well: the signature of netCDF or HDF5 tells them apart.
    std::array<char, 4> start{};
    std::ifstream(path, std::ios::binary).read(start.data(), start.size());
    const std::string_view signature(start.data(), start.size());
    const bool sure = ending != ".g" && name.pieces == 0 && name.of_restart.empty();
    return sure || signature.starts_with("CDF") || signature == "\x89HDF";
}

bool continues_exodus(const fs::path& path) {
    const ExodusName name = exodus_name(path.filename().string());
    return (name.restart > 1 || name.piece > 0) && is_exodus(path);
}

Opened open_exodus(const fs::path& path, const command::SourceOptions& wish) {
    return find_exodus_set(path, wish.alone).and_then([&](ExodusSet set) {
        return opened<ExodusSource>(std::move(set), wish.velocity);
    });
}

} // namespace wakesurf::importer
