#include "importer/sources/netcdf/netcdf_file.hpp"

#include "importer/base/process_memory.hpp"
#include "importer/base/progress_marks.hpp"
#include "importer/sources/files/netcdf_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>

namespace wakesurf::importer {

using core::Error;

namespace {

tl::unexpected<Error> damaged(const std::string& file, int status) {
    return core::fail(
        Error::Code::Corrupt,
        file + " is damaged or not what it says it is (netCDF: " + nc_strerror(status) + ")");
}

template <class Named>
bool has_name(const std::vector<Named>& all, const std::string& name) {
    return std::any_of(all.begin(), all.end(),
                       [&](const Named& each) { return each.name == name; });
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

core::Result<void> NetcdfFile::list() {
    int dimensions = 0;
    int variables = 0;
    if (const int status = nc_inq(*id_, &dimensions, &variables, nullptr, nullptr);
        status != NC_NOERR)
        return damaged(name_, status);
    std::array<char, NC_MAX_NAME + 1> text{};
    for (int i = 0; i < dimensions; ++i) {
        NetcdfDimension dimension;
        if (const int status = nc_inq_dim(*id_, i, text.data(), &dimension.length);
            status != NC_NOERR)
            return damaged(name_, status);
        dimension.name = text.data();
        if (has_name(dimensions_, dimension.name))
            return named_twice(name_, "dimensions", dimension.name);
        dimensions_.push_back(std::move(dimension));
    }
    for (int i = 0; i < variables; ++i) {
        NetcdfVariable variable;
        variable.id = i;
        std::array<int, NC_MAX_VAR_DIMS> ids{};
        int count = 0;
        if (const int status =
                nc_inq_var(*id_, i, text.data(), &variable.type, &count, ids.data(), nullptr);
            status != NC_NOERR)
            return damaged(name_, status);
        variable.name = text.data();
        // A damaged file may have two variables of one name: one would be read as the other, of another size.
        if (has_name(variables_, variable.name))
            return named_twice(name_, "variables", variable.name);
        variable.dimensions.assign(ids.begin(), ids.begin() + count);
        for (const int dimension : variable.dimensions)
            if (dimension < 0 || dimension >= dimensions)
                return core::fail(Error::Code::Corrupt,
                                  name_ + " has a damaged variable " + variable.name);
        variables_.push_back(std::move(variable));
    }
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
    if (nc_inq_att(*id_, variable.id, attribute, &type, &length) != NC_NOERR)
        return {};
    if (type == NC_STRING && length == 1) {
        char* text = nullptr;
        if (nc_get_att_string(*id_, variable.id, attribute, &text) != NC_NOERR || text == nullptr)
            return {};
        const std::string out = text;
        nc_free_string(1, &text);
        return out;
    }
    constexpr std::size_t longest = 1 << 16;
    std::string out(std::min(length, longest), '\0');
    if (type != NC_CHAR || length > longest ||
        nc_get_att_text(*id_, variable.id, attribute, out.data()) != NC_NOERR)
        return {};
    out.erase(std::find(out.begin(), out.end(), '\0'), out.end());
    return out;
}

std::vector<double> NetcdfFile::numbers(const NetcdfVariable& variable,
                                        const char* attribute) const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    constexpr std::size_t most = 1024;
    if (nc_inq_att(*id_, variable.id, attribute, &type, &length) != NC_NOERR || type == NC_CHAR ||
        type == NC_STRING || length > most)
        return {};
    std::vector<double> out(length);
    if (nc_get_att_double(*id_, variable.id, attribute, out.data()) != NC_NOERR)
        return {};
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
            nc_get_vara_double(*id_, variable.id, start.empty() ? &none : start.data(),
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
