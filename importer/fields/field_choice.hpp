// The choice of velocity, scalars and solid mask among the arrays of a source, independent of any reader.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "store/store_layout.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Returns the name by which a field is known: one of the cells that has its name from one of the points gets "(cells)" behind it.
/// @param all  of the source
std::string told_apart(const core::FieldInfo& field, const std::vector<core::FieldInfo>& all);

/// Holds a 1-component array as it is, or the magnitude of a vector that is not the velocity.
struct ChosenScalar {
    core::FieldInfo field; ///< of the source
    store::StoredScalar stored;

    bool is_magnitude() const { return field.components > 1; }

    /// Returns the field as a dataset lists it.
    core::FieldInfo info() const;
};

/// What an array with the name of a mask marks: --mask.
enum class MaskUse {
    Body,  ///< a solid that stays where it is
    Gap,   ///< at each time, where there is no fluid
    Scalar ///< nothing
};

struct FieldWish {
    std::vector<std::string> kept; ///< --fields: beside the velocity; none: all
    std::string velocity;          ///< --velocity; empty: by its name
    /// The arrays with the name of a mask that hold other values than 0 and 1.
    std::vector<std::string> no_masks{};
    std::vector<StatedComponents> stated{}; ///< as SourceDescription has them
    MaskUse mask_use = MaskUse::Body;
};

struct FieldChoice {
    FieldParts velocity;
    std::string velocity_name; ///< for people: U; u, v, w; Momentum / Density
    std::string why;
    std::vector<ChosenScalar> scalars;
    std::optional<core::FieldInfo> mask; ///< unless its use is Scalar
    bool mask_marks_solid = false;       ///< 1 means solid instead of fluid
    MaskUse mask_use = MaskUse::Body;    ///< Body or Gap
    std::string note; ///< what is left out or stored as its magnitude; may be empty

    /// Returns every array that has to be read, each once.
    std::vector<core::FieldInfo> arrays() const;
};

/// Chooses the fields. Velocity: as velocity_choice.hpp does. Mask: the 1-component array called mask, fluid,
/// fluid_mask or vtkValidPointMask (1 = fluid), or solid, solid_mask or obstacle (1 = solid), unless
/// `wish.no_masks` has it. Scalars: all other 1-component arrays, and the magnitudes of other vectors as
/// `NAME magnitude`, or those among `wish.kept` if it names some. Of two vectors with one name, that of the points is chosen, of a vector's
/// magnitude and an array the array; two scalars are told apart. Error: NotFound (no velocity; a wanted field is missing),
/// InvalidArgument (several candidates), Unsupported (a momentum without its density, parts in different
/// units), each listing what there is.
core::Result<FieldChoice> choose_fields(const std::vector<core::FieldInfo>& fields,
                                        const FieldWish& wish = {});

} // namespace wakesurf::importer
