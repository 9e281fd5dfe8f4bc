#include "server/import/image_header.hpp"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

namespace wakesurf::server {

using core::Error;

namespace {

// A file that was cut off parses, up to where it ends, as one that was not.
core::Result<void> check_ending(const SeriesFile& file) {
    std::ifstream in(file.path, std::ios::binary | std::ios::ate);
    if (!in)
        return core::fail(Error::Code::Io, "cannot open " + file.name);
    const auto size = static_cast<std::streamoff>(in.tellg());
    constexpr std::streamoff most = 256;
    std::string tail(static_cast<std::size_t>(std::min(size, most)), '\0');
    in.seekg(size - static_cast<std::streamoff>(tail.size()));
    in.read(tail.data(), static_cast<std::streamsize>(tail.size()));
    if (size == 0)
        return core::fail(Error::Code::Corrupt, file.name + " is empty");
    if (tail.find("</VTKFile>") == std::string::npos)
        return core::fail(Error::Code::Corrupt, file.name + " is truncated or not a VTK XML file");
    return {};
}

using Extent = std::array<std::int64_t, 6>;

// Modulo 2^64: an extent for which that matters is refused as too large later.
std::uint64_t cells(const Extent& e) {
    return static_cast<std::uint64_t>(e[1] - e[0]) * static_cast<std::uint64_t>(e[3] - e[2]) *
           static_cast<std::uint64_t>(e[5] - e[4]);
}

bool overlap(const Extent& a, const Extent& b) {
    return a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3] && a[4] < b[5] && b[4] < a[5];
}

std::optional<Extent> extent_of(vtkXMLDataElement& element, const char* name) {
    std::array<int, 6> read{};
    if (element.GetVectorAttribute(name, 6, read.data()) != 6)
        return std::nullopt;
    Extent extent;
    std::copy(read.begin(), read.end(), extent.begin());
    return extent;
}

core::Result<void> check_pieces(vtkXMLDataElement& image, const std::string& name) {
    const auto damaged =
        core::fail(Error::Code::Corrupt, name + " has pieces that do not fit its extent");
    constexpr std::size_t most = 10'000;
    const auto whole = extent_of(image, "WholeExtent");
    if (!whole)
        return damaged;
    for (std::size_t axis = 0; axis < 6; axis += 2)
        if ((*whole)[axis] >= (*whole)[axis + 1])
            return {}; // no cells to cover; whoever needs three dimensions says so
    std::vector<Extent> pieces;
    std::uint64_t covered = 0;
    for (int i = 0; i < image.GetNumberOfNestedElements() && pieces.size() < most; ++i) {
        auto* element = image.GetNestedElement(i);
        if (std::string_view(element->GetName()) != "Piece")
            continue;
        const auto piece = extent_of(*element, "Extent");
        if (!piece)
            return damaged;
        for (std::size_t axis = 0; axis < 6; axis += 2)
            if ((*piece)[axis] < (*whole)[axis] || (*piece)[axis + 1] > (*whole)[axis + 1] ||
                (*piece)[axis] >= (*piece)[axis + 1])
                return damaged;
        if (std::any_of(pieces.begin(), pieces.end(),
                        [&](const Extent& e) { return overlap(e, *piece); }))
            return damaged;
        pieces.push_back(*piece);
        covered += cells(*piece);
    }
    if (covered != cells(*whole))
        return damaged;
    return {};
}

core::Result<void> check_numbers(vtkXMLDataElement& image, const std::string& name) {
    const auto check = [&](const char* attribute, int count) {
        std::array<double, 9> values{};
        return image.GetAttribute(attribute) == nullptr ||
               (image.GetVectorAttribute(attribute, count, values.data()) == count &&
                std::all_of(values.begin(), values.end(),
                            [](double v) { return std::isfinite(v); }));
    };
    for (const auto& [attribute, count] :
         {std::pair{"Origin", 3}, {"Spacing", 3}, {"Direction", 9}})
        if (!check(attribute, count))
            return core::fail(Error::Code::Corrupt, name + " has a damaged " + attribute + ": " +
                                                        std::to_string(count) +
                                                        " finite numbers are expected");
    return {};
}

} // namespace

core::Result<void> check_image_header(const SeriesFile& file) {
    if (auto whole = check_ending(file); !whole)
        return whole;
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
        vtkXMLUtilities::ReadElementFromFile(file.path.c_str()));
    auto* image = root ? root->FindNestedElementWithName("ImageData") : nullptr;
    if (image == nullptr)
        return core::fail(Error::Code::Corrupt, file.name + " is not a VTK image file");
    if (auto numbers = check_numbers(*image, file.name); !numbers)
        return numbers;
    return check_pieces(*image, file.name);
}

} // namespace wakesurf::server
