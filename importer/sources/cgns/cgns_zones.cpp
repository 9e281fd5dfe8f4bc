#include "importer/sources/cgns/cgns_zones.hpp"

#include "importer/sources/cgns/cgns_mesh.hpp"
#include "importer/sources/cgns/cgns_solutions.hpp"

namespace wakesurf::importer {

core::Result<std::vector<Leaf>> read_cgns_zones(const ListedFile& file,
                                                std::optional<std::size_t> step,
                                                const WantedArrays& wanted) {
    const CgnsFile opened(file.path);
    int bases = 0;
    if (!opened.sound() || cg_nbases(opened.id(), &bases) != CG_OK)
        return cgns_damage(file.name);
    std::vector<Leaf> out;
    for (int base = 1; base <= bases; ++base) {
        CgnsName base_name{};
        int cells = 0;
        int space = 0;
        int zones = 0;
        if (cg_base_read(opened.id(), base, base_name.data(), &cells, &space) != CG_OK ||
            cg_nzones(opened.id(), base, &zones) != CG_OK)
            return cgns_damage(file.name);
        for (int zone = 1; cells == 3 && zone <= zones; ++zone) {
            CgnsZone at{file.name, opened.id(), base, zone};
            CgnsName name{};
            CGNS_ENUMT(ZoneType_t) type{};
            if (cg_zone_read(at.file, base, zone, name.data(), at.size.data()) != CG_OK ||
                cg_zone_type(at.file, base, zone, &type) != CG_OK)
                return cgns_damage(file.name);
            at.structured = type == CGNS_ENUMV(Structured);
            auto mesh = read_cgns_mesh(at);
            if (!mesh)
                return tl::unexpected(mesh.error());
            if (auto added = add_cgns_solutions(at, step, wanted, **mesh); !added)
                return tl::unexpected(added.error());
            out.push_back({{base_name.data(), name.data()}, std::move(*mesh)});
        }
    }
    return out;
}

} // namespace wakesurf::importer
