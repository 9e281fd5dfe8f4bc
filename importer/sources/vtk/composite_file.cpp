#include "core/base/disk.hpp"
#include "importer/base/library_messages.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/files/bounded_xml.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/vtk/vtk_file.hpp"
#include "importer/sources/vtk/xml_header.hpp"

#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

constexpr int deepest = 16;

core::Result<XmlHeader> header_of(const ListedFile& file, bool of_blocks) {
    const VtkMessages messages;
    auto header = read_xml_header(file, of_blocks);
    if (auto clean = messages.verdict(file.name); !clean)
        return tl::unexpected(clean.error());
    return header;
}

bool is_of_blocks(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return extension == ".vtm" || extension == ".vtmb";
}

std::string joined(const std::string& block, const std::string& name) {
    return block.empty() || name.empty() ? block + name : block + "/" + name;
}

class Expansion {
  public:
    core::Result<void> add(const ListedFile& file, const std::string& named_by, int depth) {
        if (const auto there = core::PosixDisk().size(file.path); !there) {
            if (there.error().code == Error::Code::NotFound && !named_by.empty())
                return core::fail(Error::Code::NotFound,
                                  named_by + " names " + file.name + ", which does not exist");
            return tl::unexpected(there.error());
        }
        if (depth > deepest)
            return core::fail(Error::Code::Unsupported, file.name + " is nested too deeply");
        out.files.push_back(file);
        if (is_of_blocks(file.path))
            return add_blocks_of(file, depth);
        if (names_others(file.path))
            return add_pieces_of(file, lower_extension(file.path), depth);
        out.leaves.push_back(file);
        return {};
    }

    CompositeFile out;

  private:
    core::Result<void> add_blocks_of(const ListedFile& file, int depth) {
        const auto header = header_of(file, true);
        if (!header)
            return tl::unexpected(header.error());
        if (header->cut)
            out.cut = file.name;
        if (header->type != "vtkMultiBlockDataSet")
            return core::fail(Error::Code::Corrupt, file.name + " is not a multi-block file");
        return add_elements(*header->primary, file, file.block, depth);
    }

    core::Result<void> add_elements(vtkXMLDataElement& parent,
                                    const ListedFile& file,
                                    const std::string& block,
                                    int depth) {
        for (int i = 0; i < parent.GetNumberOfNestedElements(); ++i) {
            auto* element = parent.GetNestedElement(i);
            const std::string_view kind = element->GetName();
            const auto here = joined(block, xml_attribute(*element, "name"));
            if (kind == "Block" || kind == "Piece") {
                if (auto added = add_elements(*element, file, here, depth); !added)
                    return added;
            } else if (const auto name = xml_attribute(*element, "file");
                       kind == "DataSet" &&
                       !name.empty()) { // a DataSet without a file is an empty block
                const auto path = named_path(file.path.parent_path(), name, file.name);
                if (!path)
                    return tl::unexpected(path.error());
                if (auto added = add({*path, name_for_messages(name), here}, file.name, depth + 1);
                    !added)
                    return added;
            }
        }
        return {};
    }

    // Pieces of unstructured files are leaves; VTK puts the pieces of structured ones together.
    core::Result<void>
    add_pieces_of(const ListedFile& file, const std::string& extension, int depth) {
        const auto header = header_of(file, false);
        if (!header)
            return tl::unexpected(header.error());
        const bool apart = extension == ".pvtu" || extension == ".pvtp";
        Expansion pieces;
        for (int i = 0; i < header->primary->GetNumberOfNestedElements(); ++i) {
            auto* element = header->primary->GetNestedElement(i);
            if (std::string_view(element->GetName()) != "Piece")
                continue;
            const auto name = xml_attribute(*element, "Source");
            if (name.empty())
                return core::fail(Error::Code::Corrupt, file.name + " has a piece without a file");
            const auto path = named_path(file.path.parent_path(), name, file.name);
            if (!path)
                return tl::unexpected(path.error());
            if (auto added =
                    pieces.add({*path, name_for_messages(name), file.block}, file.name, depth + 1);
                !added)
                return added;
        }
        if (pieces.out.leaves.empty())
            return core::fail(Error::Code::Corrupt, file.name + " names no pieces");
        out.files.insert(out.files.end(), pieces.out.files.begin(), pieces.out.files.end());
        if (apart)
            out.leaves.insert(out.leaves.end(), pieces.out.leaves.begin(), pieces.out.leaves.end());
        else
            out.leaves.push_back(file);
        return {};
    }
};

} // namespace

bool names_others(const std::filesystem::path& path) {
    return is_of_blocks(path) || lower_extension(path).starts_with(".pvt");
}

core::Result<CompositeFile> expand(const ListedFile& file) {
    Expansion expansion;
    return expansion.add(file, {}, 0).map([&] { return std::move(expansion.out); });
}

} // namespace wakesurf::importer
