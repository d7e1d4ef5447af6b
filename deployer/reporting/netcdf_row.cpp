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

template <class T>
void store(char* at, std::uint64_t bits) {
    const T number = static_cast<T>(bits);
    std::memcpy(at, &number, sizeof number);
}

void store(char* at, std::size_t bytes, std::uint64_t bits) {
    switch (bytes) {
        case 1: return store<std::uint8_t>(at, bits);
        case 2: return store<std::uint16_t>(at, bits);
        case 4: return store<std::uint32_t>(at, bits);
        default: return store<std::uint64_t>(at, bits);
    }
}

}  // namespace

void NetcdfRow::begin() {
    layout_.addRow();
    cut_ = false;
    wanted_.assign(columns_.all().size(), 0);
}

char* NetcdfRow::room(std::size_t column, std::size_t elements) {
    if (column >= wanted_.size()) wanted_.resize(column + 1);
    wanted_[column] = elements;
    if (column < layout_.variables().size()) {
        NetcdfVariable& variable = layout_.variables()[column];
        if (elements * variable.bytes <= variable.empty.size())
            return variable.waiting.data() + variable.waiting.size() - variable.empty.size();
    }
    cut_ = true;
    return nullptr;
}

void NetcdfRow::putNumber(std::size_t column, std::uint64_t bits) {
    if (char* const at = room(column, 1)) store(at, layout_.variables()[column].bytes, bits);
}

void NetcdfRow::putText(std::size_t column, std::string_view text) {
    if (char* const at = room(column, text.size())) std::copy(text.begin(), text.end(), at);
}

void NetcdfRow::putOther(std::size_t column, RecordReader& record) {
    const OtherValue* const other = record.value<const OtherValue*>();
    const char* const bytes = record.bytes(other->size());
    const ValueType& type = columns_.all()[column].type;
    if (type.number != Number::Enumeration) return putText(column, other->text(bytes));
    alignas(std::max_align_t) char value[sizeof(std::uint64_t)] = {};
    std::memcpy(value, bytes, std::min(other->size(), sizeof value));
    putNumber(column, static_cast<std::uint64_t>(type.numbers->get(value)));
}

void NetcdfRow::value(std::size_t column, Tag tag, RecordReader& record) {
    if (tag == Tag::Text)
        putText(column, record.text());
    else if (tag == Tag::Other)
        putOther(column, record);
    else
        putNumber(column, bitsOf(tag, record));
}

void NetcdfRow::elements(std::size_t column, std::uint32_t count, RecordReader& record) {
    char* at = room(column, count);
    const std::size_t bytes = at ? layout_.variables()[column].bytes : 0;
    for (std::uint32_t i = 0; i != count; ++i, at += bytes) {
        const Tag tag = record.tag();
        const std::uint64_t bits = bitsOf(tag, record);
        if (at) store(at, bytes, bits);
    }
}

void NetcdfRow::count(std::size_t column, std::uint32_t count) { putNumber(column, count); }

}  // namespace OCL::reporting
