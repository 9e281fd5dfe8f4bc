#include "importer/sources/files/bounded_xml.hpp"

#include <algorithm>
#include <vector>

namespace wakesurf::importer {

namespace {

constexpr int deepest = 64; // files that people write have some 5, blocks of blocks some 10

class BoundedParser final : public vtkXMLDataParser {
  public:
    static BoundedParser* New() {
        auto* made = new BoundedParser; // VTK counts its references
        made->InitializeObjectBase();
        return made;
    }

    bool too_deep() const { return too_deep_; }

  protected:
    // Deeper elements are left out of the tree, which is complete otherwise: VTK assumes that the root was
    // closed.
    void StartElement(const char* name, const char** attributes) override {
        if (++depth_ <= deepest)
            vtkXMLDataParser::StartElement(name, attributes);
        too_deep_ = too_deep_ || depth_ > deepest;
    }

    void EndElement(const char* name) override {
        if (depth_-- <= deepest)
            vtkXMLDataParser::EndElement(name);
    }

  private:
    int depth_ = 0;
    bool too_deep_ = false;
};

} // namespace

std::optional<std::string> closed_xml(std::string_view text) {
    std::vector<std::string_view> open;
    std::size_t whole = 0; // behind the last whole tag
    for (auto at = text.find('<'); at != std::string_view::npos; at = text.find('<', whole)) {
        const auto tag = text.substr(at);
        const bool comment = tag.starts_with("<!--");
        if (comment || tag.starts_with("<?")) {
            const std::string_view last = comment ? "-->" : "?>";
            const auto end = tag.find(last);
            if (end == std::string_view::npos)
                break;
            whole = at + end + last.size();
            continue;
        }
        char quote = 0;
        std::size_t end = 1;
        for (; end < tag.size() && (quote != 0 || tag[end] != '>'); ++end)
            if (quote != 0 ? tag[end] == quote : tag[end] == '"' || tag[end] == '\'')
                quote = quote != 0 ? '\0' : tag[end];
        if (end >= tag.size())
            break;
        whole = at + end + 1;
        if (tag[1] == '/') {
            if (open.empty())
                return std::nullopt;
            open.pop_back();
        } else if (tag[1] != '!' && tag[end - 1] != '/') {
            open.push_back(tag.substr(1, std::min(end, tag.find_first_of(" \t\r\n")) - 1));
        }
    }
    if (open.empty())
        return std::nullopt;
    std::string out(text.substr(0, whole));
    for (; !open.empty(); open.pop_back())
        out += "</" + std::string(open.back()) + ">";
    return out;
}

core::Result<vtkSmartPointer<vtkXMLDataParser>> parse_xml(std::istream& in,
                                                          const std::string& file) {
    const auto parser = vtkSmartPointer<BoundedParser>::New();
    parser->SetStream(&in);
    const bool parsed = parser->Parse() != 0;
    if (parser->too_deep())
        return core::fail(core::Error::Code::Corrupt,
                          file + " has elements nested more than " + std::to_string(deepest) +
                              " deep",
                          "it is probably damaged; write it again, with fewer nested blocks");
    if (!parsed)
        return vtkSmartPointer<vtkXMLDataParser>::New();
    return vtkSmartPointer<vtkXMLDataParser>(parser);
}

} // namespace wakesurf::importer
