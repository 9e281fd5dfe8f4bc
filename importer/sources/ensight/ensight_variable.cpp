#include "importer/base/reading_bounds.hpp"
#include "importer/sources/ensight/ensight_file.hpp"

#include <algorithm>
#include <limits>
#include <new>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

// Reads the values of one section: all first components, then all second ones.
core::Result<void>
append(EnsightStream& in, std::size_t count, bool undefined, vtkFloatArray* out, int components) {
    float mark = 0.0f;
    if (undefined) {
        const auto found = in.numbers(1);
        if (!found)
            return tl::unexpected(found.error());
        mark = found->front();
    }
    const vtkIdType start = out == nullptr ? 0 : out->GetNumberOfTuples();
    for (int c = 0; c < components; ++c) {
        const auto values = in.numbers(count);
        if (!values)
            return tl::unexpected(values.error());
        if (out == nullptr)
            continue;
        if (c == 0)
            out->Resize(start + static_cast<vtkIdType>(count));
        out->SetNumberOfTuples(start + static_cast<vtkIdType>(count));
        for (std::size_t i = 0; i < count; ++i)
            out->SetTypedComponent(start + static_cast<vtkIdType>(i), c,
                                   undefined && (*values)[i] == mark
                                       ? std::numeric_limits<float>::quiet_NaN()
                                       : (*values)[i]);
    }
    return {};
}

vtkSmartPointer<vtkFloatArray> new_array(const FieldInfo& field) {
    auto out = vtkSmartPointer<vtkFloatArray>::New();
    out->SetName(field.name.c_str());
    out->SetNumberOfComponents(field.components);
    return out;
}

core::Result<EnsightValues>
read_values(EnsightStream& in, const EnsightPart& part, const FieldInfo& field) {
    EnsightValues out{new_array(field), new_array(field)};
    const bool at_nodes = field.source == FieldInfo::Source::Point;
    auto section = part.sections.begin();
    bool any = false;
    while (!in.at_end()) {
        auto type = in.line();
        if (!type)
            return tl::unexpected(type.error());
        if (*type == "part") {
            in.unread_line();
            break;
        }
        const bool undefined = type->ends_with(" undef");
        if (undefined)
            type->resize(type->size() - std::string(" undef").size());
        if (type->ends_with(" partial"))
            return core::fail(Error::Code::Unsupported,
                              field.name + " has values at some elements only",
                              "write values everywhere");
        vtkFloatArray* target = out.volume;
        std::size_t count = part.nodes;
        if (at_nodes && (any || (*type != "coordinates" && *type != "block")))
            return in.damaged("'" + *type + "' stands where values of nodes should begin");
        if (!at_nodes) {
            // A type may be left out where there are no values.
            section = std::find_if(section, part.sections.end(),
                                   [&](const EnsightSection& one) { return one.type == *type; });
            if (section == part.sections.end())
                return in.damaged("'" + *type + "' is not a type of element of part " + part.name);
            count = section->count;
            target = section->dimension == 3   ? out.volume
                     : section->dimension == 2 ? out.faces
                                               : nullptr;
            ++section;
        }
        any = true;
        if (auto read = append(in, count, undefined, target, field.components); !read)
            return tl::unexpected(read.error());
    }
    if (at_nodes)
        out.faces = out.volume;
    return out;
}

} // namespace

core::Result<std::map<std::size_t, EnsightValues>> read_ensight_variable(
    const NamedFile& file, const EnsightGeometry& geometry, const FieldInfo& field) {
    auto in = EnsightStream::open(file);
    if (!in)
        return tl::unexpected(in.error());
    in->set_encoding(geometry.encoding, geometry.swapped);
    using Values = std::map<std::size_t, EnsightValues>;
    return within_memory(file.name, [&]() -> core::Result<Values> {
        Values out;
        if (auto description = in->line(); !description)
            return tl::unexpected(description.error());
        while (!in->at_end()) {
            const auto word = in->line();
            if (!word)
                return tl::unexpected(word.error());
            if (*word != "part")
                return in->damaged("'" + *word + "' stands where a part should begin");
            const auto number = in->integers(1);
            if (!number)
                return tl::unexpected(number.error());
            const auto part = geometry.parts.find(static_cast<std::size_t>(number->front()));
            if (part == geometry.parts.end())
                return in->damaged("the mesh has no part " + std::to_string(number->front()));
            auto values = read_values(*in, part->second, field);
            if (!values)
                return tl::unexpected(values.error());
            out[part->first] = std::move(*values);
        }
        return out;
    });
}

} // namespace wakesurf::importer
