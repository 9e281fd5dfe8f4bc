// A Plot3D grid file, whose layout follows from its length, and behind a border the solution on it.
#include "importer/sources/plot3d/plot3d_files.hpp"
#include "tests/fuzz/targets/all.hpp"
#include "tests/fuzz/targets/scratch_file.hpp"

#include <algorithm>
#include <cstdint>

namespace wakesurf::fuzz {

namespace {

constexpr std::string_view border = "\n====\n";

// Writes numbers as one layout has them.
class Writer {
  public:
    explicit Writer(const importer::Plot3dLayout& layout) : layout_(layout) {}

    void integers(const std::vector<int>& values) {
        std::string bytes;
        for (const int value : values)
            bytes += layout_.ascii ? std::to_string(value) + ' ' : bytes_of(value);
        record(bytes);
    }

    void reals(std::size_t count) {
        std::string bytes;
        for (std::size_t i = 0; i < count; ++i)
            bytes += layout_.ascii     ? "0.5 "
                     : layout_.doubles ? bytes_of(0.5 * static_cast<double>(i))
                                       : bytes_of(0.5f * static_cast<float>(i));
        record(bytes);
    }

    const std::string& text() const { return text_; }

  private:
    template <class Number>
    std::string bytes_of(Number number) const {
        std::string out(reinterpret_cast<const char*>(&number), sizeof number);
        if (layout_.big_endian)
            std::reverse(out.begin(), out.end());
        return out;
    }

    void record(const std::string& bytes) {
        const std::string mark =
            layout_.records ? bytes_of(static_cast<std::int32_t>(bytes.size())) : std::string();
        text_ += mark + bytes + mark;
    }

    const importer::Plot3dLayout& layout_;
    std::string text_;
};

std::string files(const importer::Plot3dLayout& layout) {
    const std::size_t blocks = layout.several ? 2 : 1;
    constexpr std::size_t nodes = 2 * 3 * 2;
    const auto header = [&](Writer& out) {
        if (layout.several)
            out.integers({2});
        std::vector<int> sizes;
        for (std::size_t i = 0; i < blocks; ++i)
            sizes.insert(sizes.end(), {2, 3, 2});
        out.integers(sizes);
    };
    Writer grid(layout), solution(layout);
    header(grid);
    header(solution);
    for (std::size_t i = 0; i < blocks; ++i) {
        grid.reals(3 * nodes);
        if (layout.blanking)
            grid.integers(std::vector<int>(nodes, 1));
        solution.reals(4);
        solution.reals(5 * nodes);
    }
    return grid.text() + std::string(border) + solution.text();
}

void run(Input input) {
    const auto text = text_of(input);
    const auto cut = std::min(text.find(border), text.size());
    const importer::ListedFile grid{scratch_file("a.xyz", text.substr(0, cut)), "a.xyz", ""};
    const auto layout = importer::grid_layout(grid);
    if (!layout)
        return;
    for (const auto& block : layout->blocks)
        demand(block[0] > 0 && block[1] > 0 && block[2] > 0, "a block has nodes along each axis");
    const auto rest = text.substr(std::min(cut + border.size(), text.size()));
    importer::check_solution({scratch_file("a.q", rest), "a.q", ""}, *layout);
}

std::vector<std::string> seeds() {
    std::vector<std::string> seeds{
        std::string("\xff\xff\xff\x7f\xff\xff\xff\x7f\xff\xff\xff\x7f", 12)};
    for (const bool several : {false, true}) {
        importer::Plot3dLayout layout;
        layout.several = several;
        seeds.push_back(files(layout));
        layout.big_endian = layout.records = true;
        seeds.push_back(files(layout));
        layout.doubles = true;
        seeds.push_back(files(layout));
        layout = {};
        layout.ascii = layout.blanking = true;
        layout.several = several;
        seeds.push_back(files(layout));
    }
    return seeds;
}

} // namespace

const Target plot3d_target{"plot3d", run, seeds};

} // namespace wakesurf::fuzz
