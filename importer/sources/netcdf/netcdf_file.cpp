#include "importer/sources/netcdf/netcdf_file.hpp"

#include "importer/base/reading_bounds.hpp"
#include "importer/sources/files/netcdf_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <new>
#include <set>

namespace wakesurf::importer {

using core::Error;

namespace {

tl::unexpected<Error> damaged(const std::string& file, int status) {
    return core::fail(Error::Code::Corrupt,
                      file + " is damaged, or not the kind of file that it claims to be (netCDF: " +
                          nc_strerror(status) + ")");
}

tl::unexpected<Error>
named_twice(const std::string& file, const char* what, const std::string& name) {
    return core::fail(Error::Code::Corrupt,
                      file + " is damaged: it has two " + what + " called " + name);
}

// Holds how values are packed, and which of them are missing.
struct Packing {
    double scale = 1.0;
    double offset = 0.0;
    double wrap = 0.0; ///< added to negative values: unsigned ones in a signed type
    std::vector<double> missing;
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();

    double operator()(double raw) const {
        if (raw < 0.0)
            raw += wrap;
        if (!(raw >= lowest && raw <= highest) ||
            std::find(missing.begin(), missing.end(), raw) != missing.end())
            return std::numeric_limits<double>::quiet_NaN();
        return raw * scale + offset;
    }
};

// Returns the value of unwritten elements if the file does not state one; bytes have none.
std::optional<double> default_fill(nc_type type) {
    switch (type) {
    case NC_SHORT:
        return NC_FILL_SHORT;
    case NC_USHORT:
        return NC_FILL_USHORT;
    case NC_INT:
        return NC_FILL_INT;
    case NC_UINT:
        return NC_FILL_UINT;
    case NC_INT64:
        return static_cast<double>(NC_FILL_INT64);
    case NC_UINT64:
        return static_cast<double>(NC_FILL_UINT64);
    case NC_FLOAT:
        return static_cast<double>(NC_FILL_FLOAT);
    case NC_DOUBLE:
        return NC_FILL_DOUBLE;
    default:
        return std::nullopt;
    }
}

double unsigned_wrap(const NetcdfFile& file, const NetcdfVariable& variable) {
    if (file.text(variable, "_Unsigned") != "true")
        return 0.0;
    return variable.type == NC_BYTE ? 0x1p8 : variable.type == NC_SHORT ? 0x1p16 : 0x1p32;
}

Packing packing_of(const NetcdfFile& file, const NetcdfVariable& variable) {
    Packing out;
    if (const auto scale = file.numbers(variable, "scale_factor"); !scale.empty())
        out.scale = scale.front();
    if (const auto offset = file.numbers(variable, "add_offset"); !offset.empty())
        out.offset = offset.front();
    out.wrap = unsigned_wrap(file, variable);
    const auto raw = [&](double value) { return value < 0.0 ? value + out.wrap : value; };
    for (const char* attribute : {"_FillValue", "missing_value"})
        for (const double value : file.numbers(variable, attribute)) {
            out.missing.push_back(raw(value));
            if (variable.type == NC_FLOAT) // a value of a wider type than the data
                out.missing.push_back(static_cast<double>(static_cast<float>(value)));
        }
    if (const auto fill = default_fill(variable.type);
        fill && file.numbers(variable, "_FillValue").empty())
        out.missing.push_back(raw(*fill));
    if (const auto range = file.numbers(variable, "valid_range"); range.size() == 2) {
        out.lowest = raw(range[0]);
        out.highest = raw(range[1]);
    }
    if (const auto least = file.numbers(variable, "valid_min"); !least.empty())
        out.lowest = raw(least.front());
    if (const auto most = file.numbers(variable, "valid_max"); !most.empty())
        out.highest = raw(most.front());
    return out;
}

} // namespace

core::Result<NetcdfFile> NetcdfFile::open(const ListedFile& file) {
    made_progress();
    if (auto whole = check_netcdf_size({file.path, file.name}); !whole)
        return tl::unexpected(whole.error());
    NetcdfFile out;
    out.name_ = file.name;
    int id = 0;
    if (const int status = nc_open(file.path.c_str(), NC_NOWRITE, &id); status != NC_NOERR)
        return damaged(file.name, status);
    out.id_.reset(new int(id));
    if (auto listed = out.list(); !listed)
        return tl::unexpected(listed.error());
    return out;
}

// Collects what all groups have, by the path of the group: "" or "flow/".
struct NetcdfFile::Listing {
    template <class Item>
    struct Found {
        Item item;
        std::string path;
    };

    // Names an item by its path as well if another group has one of its name.
    template <class Item>
    static std::vector<Item> named(std::vector<Found<Item>>& all) {
        std::map<std::string, int> count;
        for (const auto& each : all)
            ++count[each.item.name];
        std::vector<Item> out;
        for (auto& each : all) {
            if (count[each.item.name] > 1)
                each.item.name = each.path + each.item.name;
            out.push_back(std::move(each.item));
        }
        return out;
    }

    std::vector<Found<NetcdfDimension>> dimensions;
    std::vector<Found<NetcdfVariable>> variables;
    std::map<int, int> index; ///< of a dimension, by the library's number
    int depth = 0;
};

core::Result<void> NetcdfFile::list() {
    Listing listing;
    if (auto listed = list_group(*id_, {}, listing); !listed)
        return listed;
    dimensions_ = Listing::named(listing.dimensions);
    variables_ = Listing::named(listing.variables);
    return {};
}

core::Result<void>
NetcdfFile::list_group(int group, const std::string& path, Listing& listing) const {
    constexpr int deepest = 32;
    if (listing.depth > deepest)
        return core::fail(Error::Code::OverLimit, name_ + " has more than " +
                                                      std::to_string(deepest) +
                                                      " groups within each other");
    int count = 0;
    std::array<char, NC_MAX_NAME + 1> text{};
    const auto names_all = [&](auto inquire, std::vector<int>& ids) {
        if (const int status = inquire(nullptr); status != NC_NOERR)
            return status;
        ids.resize(static_cast<std::size_t>(count));
        return count == 0 ? NC_NOERR : inquire(ids.data());
    };
    std::vector<int> ids;
    std::set<std::string> here;
    if (const int status =
            names_all([&](int* out) { return nc_inq_dimids(group, &count, out, 0); }, ids);
        status != NC_NOERR)
        return damaged(name_, status);
    for (const int id : ids) {
        NetcdfDimension dimension;
        if (const int status = nc_inq_dim(group, id, text.data(), &dimension.length);
            status != NC_NOERR)
            return damaged(name_, status);
        dimension.name = text.data();
        if (!here.insert(dimension.name).second)
            return named_twice(name_, "dimensions", dimension.name);
        listing.index[id] = static_cast<int>(listing.dimensions.size());
        listing.dimensions.push_back({std::move(dimension), path});
    }
    if (const int status = nc_inq_nvars(group, &count); status != NC_NOERR)
        return damaged(name_, status);
    here.clear();
    for (int i = 0, variables = count; i < variables; ++i) {
        NetcdfVariable variable;
        variable.id = i;
        variable.group = group;
        std::array<int, NC_MAX_VAR_DIMS> of{};
        int rank = 0;
        if (const int status =
                nc_inq_var(group, i, text.data(), &variable.type, &rank, of.data(), nullptr);
            status != NC_NOERR)
            return damaged(name_, status);
        variable.name = text.data();
        // A damaged file may have two variables of one name: one would be read as the other, of another size.
        if (!here.insert(variable.name).second)
            return named_twice(name_, "variables", variable.name);
        for (int d = 0; d < rank; ++d) {
            const auto known = listing.index.find(of[static_cast<std::size_t>(d)]);
            if (known == listing.index.end())
                return core::fail(Error::Code::Corrupt,
                                  name_ + " has a damaged variable " + variable.name);
            variable.dimensions.push_back(known->second);
        }
        listing.variables.push_back({std::move(variable), path});
    }
    if (const int status =
            names_all([&](int* out) { return nc_inq_grps(group, &count, out); }, ids);
        status != NC_NOERR)
        return damaged(name_, status);
    ++listing.depth;
    for (const int id : ids) {
        if (const int status = nc_inq_grpname(id, text.data()); status != NC_NOERR)
            return damaged(name_, status);
        if (auto listed = list_group(id, path + text.data() + "/", listing); !listed)
            return listed;
    }
    --listing.depth;
    return {};
}

const NetcdfVariable* NetcdfFile::variable(const std::string& name) const {
    const auto found = std::find_if(variables_.begin(), variables_.end(),
                                    [&](const NetcdfVariable& v) { return v.name == name; });
    return found == variables_.end() ? nullptr : &*found;
}

std::string NetcdfFile::text(const NetcdfVariable& variable, const char* attribute) const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(variable.group, variable.id, attribute, &type, &length) != NC_NOERR)
        return {};
    if (type == NC_STRING && length == 1) {
        char* text = nullptr;
        if (nc_get_att_string(variable.group, variable.id, attribute, &text) != NC_NOERR ||
            text == nullptr)
            return {};
        const std::string out = text;
        nc_free_string(1, &text);
        return out;
    }
    constexpr std::size_t longest = 1 << 16;
    std::string out(std::min(length, longest), '\0');
    if (type != NC_CHAR || length > longest ||
        nc_get_att_text(variable.group, variable.id, attribute, out.data()) != NC_NOERR)
        return {};
    out.erase(std::find(out.begin(), out.end(), '\0'), out.end());
    return out;
}

std::vector<double> NetcdfFile::numbers(const NetcdfVariable& variable,
                                        const char* attribute) const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    constexpr std::size_t most = 1024;
    if (nc_inq_att(variable.group, variable.id, attribute, &type, &length) != NC_NOERR ||
        type == NC_CHAR || type == NC_STRING || length > most)
        return {};
    std::vector<double> out(length);
    if (nc_get_att_double(variable.group, variable.id, attribute, out.data()) != NC_NOERR)
        return {};
    return out;
}

std::vector<std::string> NetcdfFile::texts(const NetcdfVariable& variable) const {
    constexpr std::size_t most = 1'000'000;
    std::size_t total = 1;
    std::size_t length = 1;
    for (const int dimension : variable.dimensions) {
        length = dimensions_[static_cast<std::size_t>(dimension)].length;
        if (length == 0 || total > most / length)
            return {};
        total *= length;
    }
    std::vector<std::string> out;
    if (variable.type == NC_CHAR) {
        std::string all(total, '\0');
        if (nc_get_var_text(variable.group, variable.id, all.data()) != NC_NOERR)
            return {};
        for (std::size_t i = 0; i < total; i += length)
            out.emplace_back(all.substr(i, length).c_str());
    } else if (variable.type == NC_STRING) {
        std::vector<char*> all(total, nullptr);
        if (nc_get_var_string(variable.group, variable.id, all.data()) != NC_NOERR)
            return {};
        for (const char* const each : all)
            out.emplace_back(each == nullptr ? "" : each);
        nc_free_string(all.size(), all.data());
    }
    return out;
}

core::Result<std::vector<double>> NetcdfFile::read(const NetcdfVariable& variable,
                                                   const std::vector<std::size_t>& start,
                                                   const std::vector<std::size_t>& count) const {
    std::size_t size = 1;
    for (const std::size_t n : count) {
        if (n != 0 && size > std::vector<double>().max_size() / n)
            return core::fail(Error::Code::OverLimit,
                              variable.name + " of " + name_ + " is larger than memory");
        size *= n;
    }
    if (auto fits = check_claim(name_, size, sizeof(double)); !fits)
        return tl::unexpected(fits.error());
    std::vector<double> out;
    try {
        out.resize(size);
    } catch (const std::bad_alloc&) {
        return core::fail(Error::Code::OverLimit,
                          "there is not enough memory to read " + variable.name + " of " + name_);
    }
    const std::size_t none = 0; // of a variable without dimensions
    if (const int status =
            nc_get_vara_double(variable.group, variable.id, start.empty() ? &none : start.data(),
                               count.empty() ? &none : count.data(), out.data());
        status != NC_NOERR)
        return core::fail(Error::Code::Corrupt,
                          variable.name + " of " + name_ +
                              " cannot be read (netCDF: " + nc_strerror(status) + ")");
    const Packing unpacked = packing_of(*this, variable);
    std::transform(out.begin(), out.end(), out.begin(), unpacked);
    return out;
}

core::Result<std::vector<double>> NetcdfFile::read(const NetcdfVariable& variable) const {
    std::vector<std::size_t> count;
    for (const int dimension : variable.dimensions)
        count.push_back(dimensions_[static_cast<std::size_t>(dimension)].length);
    return read(variable, std::vector<std::size_t>(count.size(), 0), count);
}

} // namespace wakesurf::importer
