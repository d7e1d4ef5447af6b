// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_layout.hpp"

#include <algorithm>
#include <limits>

namespace OCL::reporting {
namespace {

/** Most texts are names and short messages. */
constexpr std::size_t kTextRoom = 64;

ClassicType typeFor(const ValueType& type) {
    switch (type.number) {
        case Number::Bool:
        case Number::Char:
        case Number::Int8: return ClassicType::Byte;
        case Number::UInt8: return ClassicType::UByte;
        case Number::Int16: return ClassicType::Short;
        case Number::UInt16: return ClassicType::UShort;
        case Number::Int32: return ClassicType::Int;
        case Number::UInt32: return ClassicType::UInt;
        case Number::Int64: return ClassicType::Int64;
        case Number::UInt64: return ClassicType::UInt64;
        case Number::Float: return ClassicType::Float;
        case Number::Real: return ClassicType::Double;
        case Number::Text: return ClassicType::Char;
        case Number::Enumeration: break;
    }
    const auto fits = [](const auto& known) {
        return known.value >= -std::numeric_limits<std::int32_t>::max() &&
               known.value <= std::numeric_limits<std::int32_t>::max();
    };
    const bool small = std::all_of(type.enumerators.begin(), type.enumerators.end(), fits);
    return small ? ClassicType::Int : ClassicType::Int64;
}

/** The attributes of the CF conventions for values with names, but for names of one value. */
void addFlags(ClassicVariable& variable, const std::vector<RTT::types::Shape::Enumerator>& enumerators) {
    std::string values, names;
    std::vector<long long> seen;
    for (const auto& known : enumerators) {
        if (std::find(seen.begin(), seen.end(), known.value) != seen.end()) continue;
        seen.push_back(known.value);
        appendBig(values, variable.type, static_cast<std::uint64_t>(known.value));
        std::string name = known.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        names += (names.empty() ? "" : " ") + name;
    }
    if (seen.empty()) return;
    variable.attributes.push_back({"flag_values", variable.type, values});
    variable.attributes.push_back(ClassicAttribute::text("flag_meanings", names));
}

}  // namespace

void NetcdfLayout::add(const Column& column, bool gaps) {
    ClassicVariable variable;
    variable.name = names_.take(column.name);
    if (variable.name != column.name) renamed_.push_back(variables_.size());
    variable.type = typeFor(column.type);
    const bool isText = variable.type == ClassicType::Char;
    if (isText || column.role == Column::Role::Elements)
        variable.dimension = dimensions_.take(variable.name + (isText ? "_len" : "_dim"));
    variable.elements = isText ? kTextRoom : 1;
    const auto text = [&variable](const char* name, const std::string& value) {
        if (!value.empty()) variable.attributes.push_back(ClassicAttribute::text(name, value));
    };
    text("long_name", column.description);
    if (!isText) text("units", column.unit);
    if (variable.name != column.name) text("reported_as", column.name);
    if (column.type.number == Number::Enumeration) addFlags(variable, column.type.enumerators);
    if (column.type.number == Number::Bool) addFlags(variable, {{"false", 0}, {"true", 1}});
    // All 256 values of a byte may be data, so that one of them means a gap only where there are gaps.
    if (!isText && (sizeOf(variable.type) != 1 || gaps))
        variable.attributes.push_back({"_FillValue", variable.type, fillOf(variable.type)});
    if (column.name != "TimeStamp") text("coordinates", "TimeStamp");
    variables_.push_back(std::move(variable));
}

void NetcdfLayout::grow(const std::vector<Column>& columns, const std::vector<std::size_t>& wanted, bool gaps) {
    const bool first = variables_.empty();
    for (std::size_t i = variables_.size(); i < columns.size(); ++i) add(columns[i], gaps || !first);
    places_.resize(variables_.size());
    empty_.clear();
    for (std::size_t i = 0; i != variables_.size(); ++i) {
        ClassicVariable& variable = variables_[i];
        const bool isNew = places_[i].bytes == 0 && columns[i].role == Column::Role::Elements;
        const std::size_t need = i < wanted.size() ? wanted[i] : 0;
        // Twice as much, so that a sequence that grows and grows needs few layouts.
        if (need > variable.elements) variable.elements = isNew ? need : std::max(need, 2 * variable.elements);
        const std::size_t bytes = variable.elements * sizeOf(variable.type);
        places_[i] = {empty_.size(), bytes, variable.elements, variable.type};
        const std::string fill = fillOf(variable.type);
        for (std::size_t k = 0; k != variable.elements; ++k) empty_ += fill;
        empty_.append(variable.bytes() - bytes, '\0');
    }
}

void NetcdfLayout::appendConverted(std::string& to, const char* record, const std::vector<Place>& earlier) const {
    const std::size_t begin = to.size();
    to += empty_;
    for (std::size_t i = 0; i != earlier.size(); ++i)
        std::copy_n(record + earlier[i].begin, earlier[i].bytes,
                    to.begin() + static_cast<std::ptrdiff_t>(begin + places_[i].begin));
}

}  // namespace OCL::reporting
