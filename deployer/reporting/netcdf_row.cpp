// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_row.hpp"

#include "other_value.hpp"

#include <rtt/types/StructTable.hpp>

#include <algorithm>
#include <cstring>

namespace OCL::reporting {
namespace {

/** Reads a number; floating point numbers as they are in memory. */
std::uint64_t bitsOf(Tag tag, RecordReader& record) {
    switch (tag) {
        case Tag::Bool: return record.value<bool>() ? 1 : 0;
        case Tag::Char: return static_cast<std::uint64_t>(record.value<char>());
        case Tag::Signed: return static_cast<std::uint64_t>(record.value<std::int64_t>());
        case Tag::Float: return record.value<std::uint32_t>();
        case Tag::Unsigned:
        case Tag::Real: return record.value<std::uint64_t>();
        default: return 0;  // no number
    }
}

}  // namespace

void NetcdfRow::begin(std::string& records) {
    records_ = &records;
    begin_ = records.size();
    records += layout_.emptyRecord();
    cut_ = false;
    wanted_.assign(columns_.all().size(), 0);
}

const NetcdfLayout::Place* NetcdfRow::room(std::size_t column, std::size_t elements) {
    if (column >= wanted_.size()) wanted_.resize(column + 1);
    wanted_[column] = elements;
    const bool known = column < layout_.places().size();
    if (known && elements <= layout_.places()[column].elements) return &layout_.places()[column];
    cut_ = true;
    return nullptr;
}

void NetcdfRow::putNumber(const NetcdfLayout::Place* place, std::size_t element, std::uint64_t bits) {
    if (!place) return;
    const std::size_t size = sizeOf(place->type);
    char* const at = records_->data() + begin_ + place->begin + element * size;
    for (std::size_t i = 0; i != size; ++i) at[i] = static_cast<char>(bits >> (8 * (size - 1 - i)));
}

void NetcdfRow::putText(std::size_t column, std::string_view text) {
    if (const NetcdfLayout::Place* const place = room(column, text.size()))
        std::copy(text.begin(), text.end(), records_->data() + begin_ + place->begin);
}

void NetcdfRow::putOther(std::size_t column, RecordReader& record) {
    const OtherValue* const other = record.value<const OtherValue*>();
    const char* const bytes = record.bytes(other->size());
    const ValueType& type = columns_.all()[column].type;
    if (type.number != Number::Enumeration) return putText(column, other->text(bytes));
    alignas(std::max_align_t) char value[sizeof(std::uint64_t)] = {};
    std::memcpy(value, bytes, std::min(other->size(), sizeof value));
    putNumber(room(column, 1), 0, static_cast<std::uint64_t>(type.numbers->get(value)));
}

void NetcdfRow::value(std::size_t column, Tag tag, RecordReader& record) {
    if (tag == Tag::Text)
        putText(column, record.text());
    else if (tag == Tag::Other)
        putOther(column, record);
    else
        putNumber(room(column, 1), 0, bitsOf(tag, record));
}

void NetcdfRow::elements(std::size_t column, std::uint32_t count, RecordReader& record) {
    const NetcdfLayout::Place* const place = room(column, count);
    for (std::uint32_t i = 0; i != count; ++i) {
        const Tag tag = record.tag();
        putNumber(place, i, bitsOf(tag, record));
    }
}

void NetcdfRow::count(std::size_t column, std::uint32_t count) { putNumber(room(column, 1), 0, count); }

}  // namespace OCL::reporting
