// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_layout.hpp"

#include <algorithm>
#include <limits>

namespace OCL::reporting {
namespace {

/** Most texts are names and short messages. */
constexpr std::size_t kTextRoom = 64;

struct Type {
    nc_type type;
    std::size_t bytes;
};

Type typeFor(const ValueType& type) {
    switch (type.number) {
        case Number::Bool:
        case Number::Char:
        case Number::Int8: return {NC_BYTE, 1};
        case Number::UInt8: return {NC_UBYTE, 1};
        case Number::Int16: return {NC_SHORT, 2};
        case Number::UInt16: return {NC_USHORT, 2};
        case Number::Int32: return {NC_INT, 4};
        case Number::UInt32: return {NC_UINT, 4};
        case Number::Int64: return {NC_INT64, 8};
        case Number::UInt64: return {NC_UINT64, 8};
        case Number::Float: return {NC_FLOAT, 4};
        case Number::Real: return {NC_DOUBLE, 8};
        case Number::Text: return {NC_CHAR, 1};
        case Number::Enumeration: break;
    }
    const auto fits = [](const auto& known) {
        return known.value >= -std::numeric_limits<std::int32_t>::max() &&
               known.value <= std::numeric_limits<std::int32_t>::max();
    };
    const bool small = std::all_of(type.enumerators.begin(), type.enumerators.end(), fits);
    return small ? Type{NC_INT, 4} : Type{NC_INT64, 8};
}

/** The attributes of the CF conventions for values with names, but for names of one value. */
void addFlags(NetcdfVariable& variable, const std::vector<RTT::types::Shape::Enumerator>& enumerators) {
    std::string names;
    std::vector<long long>& values = variable.flags;
    for (const auto& known : enumerators) {
        if (std::find(values.begin(), values.end(), known.value) != values.end()) continue;
        values.push_back(known.value);
        std::string name = known.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        names += (names.empty() ? "" : " ") + name;
    }
    if (!values.empty()) variable.texts.push_back({"flag_meanings", names});
}

}  // namespace

void NetcdfLayout::add(const Column& column, bool gaps) {
    NetcdfVariable variable;
    variable.name = names_.take(column.name);
    const bool isRenamed = variable.name != column.name;
    if (isRenamed) renamed_.push_back(variables_.size());
    const Type type = typeFor(column.type);
    variable.type = type.type;
    variable.bytes = type.bytes;
    const bool isText = variable.type == NC_CHAR;
    if (isText || column.role == Column::Role::Elements)
        variable.dimension = dimensions_.take(variable.name + (isText ? "_len" : "_dim"));
    variable.elements = isText ? kTextRoom : 1;
    const auto text = [&variable](const char* name, const std::string& value) {
        if (!value.empty()) variable.texts.push_back({name, value});
    };
    text("long_name", column.description);
    if (!isText) text("units", column.unit);
    if (isRenamed) text("reported_as", column.name);
    if (column.type.number == Number::Enumeration) addFlags(variable, column.type.enumerators);
    if (column.type.number == Number::Bool) addFlags(variable, {{"false", 0}, {"true", 1}});
    // All 256 values of a byte may be data, so that one of them means a gap only where there are gaps.
    variable.hasFill = !isText && (variable.bytes != 1 || gaps);
    if (column.name != "TimeStamp") text("coordinates", "TimeStamp");
    variables_.push_back(std::move(variable));
}

void NetcdfLayout::grow(const std::vector<Column>& columns, const std::vector<std::size_t>& wanted, bool gaps) {
    const std::size_t earlier = variables_.size();
    for (std::size_t i = earlier; i < columns.size(); ++i) add(columns[i], gaps || earlier != 0);
    for (std::size_t i = 0; i != std::min(wanted.size(), variables_.size()); ++i) {
        std::size_t& elements = variables_[i].elements;
        if (wanted[i] <= elements) continue;
        // Twice as much, so that a sequence that grows and grows needs few files.
        const bool isNew = i >= earlier && columns[i].role == Column::Role::Elements;
        elements = isNew ? wanted[i] : std::max(wanted[i], 2 * elements);
    }
}

void NetcdfLayout::addRow() {
    for (NetcdfVariable& variable : variables_) variable.waiting += variable.empty;
}

void NetcdfLayout::takeBackRow() {
    for (NetcdfVariable& variable : variables_)
        variable.waiting.resize(variable.waiting.size() - variable.empty.size());
}

void NetcdfLayout::clearRows() {
    for (NetcdfVariable& variable : variables_) variable.waiting.clear();
}

}  // namespace OCL::reporting
