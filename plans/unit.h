#pragma once
// Units of length that files and flags speak of.

#include <optional>
#include <string_view>

namespace enfilade::plans {

enum class Unit { Millimetre, Centimetre, Decimetre, Metre, Kilometre, Inch, Foot, Yard, Mile };

[[nodiscard]] constexpr double metres(Unit unit) {
    switch (unit) {
        case Unit::Millimetre: return 0.001;
        case Unit::Centimetre: return 0.01;
        case Unit::Decimetre: return 0.1;
        case Unit::Metre: return 1;
        case Unit::Kilometre: return 1000;
        case Unit::Inch: return 0.0254;
        case Unit::Foot: return 0.3048;
        case Unit::Yard: return 0.9144;
        case Unit::Mile: return 1609.344;
    }
    return 1;
}

[[nodiscard]] constexpr const char* name_of(Unit unit) {
    switch (unit) {
        case Unit::Millimetre: return "mm";
        case Unit::Centimetre: return "cm";
        case Unit::Decimetre: return "dm";
        case Unit::Metre: return "m";
        case Unit::Kilometre: return "km";
        case Unit::Inch: return "in";
        case Unit::Foot: return "ft";
        case Unit::Yard: return "yd";
        case Unit::Mile: return "mi";
    }
    return "m";
}

/// The unit in a sentence: "inches".
[[nodiscard]] constexpr const char* plural_of(Unit unit) {
    switch (unit) {
        case Unit::Millimetre: return "millimetres";
        case Unit::Centimetre: return "centimetres";
        case Unit::Decimetre: return "decimetres";
        case Unit::Metre: return "metres";
        case Unit::Kilometre: return "kilometres";
        case Unit::Inch: return "inches";
        case Unit::Foot: return "feet";
        case Unit::Yard: return "yards";
        case Unit::Mile: return "miles";
    }
    return "metres";
}

/// The unit of that short name; nothing for others.
[[nodiscard]] constexpr std::optional<Unit> unit_of(std::string_view name) {
    for (const Unit unit : {Unit::Millimetre, Unit::Centimetre, Unit::Decimetre, Unit::Metre, Unit::Kilometre,
                            Unit::Inch, Unit::Foot, Unit::Yard, Unit::Mile})
        if (name == name_of(unit)) return unit;
    return std::nullopt;
}

}  // namespace enfilade::plans
