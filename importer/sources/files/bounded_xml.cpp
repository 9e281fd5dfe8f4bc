#include "importer/sources/files/bounded_xml.hpp"

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
