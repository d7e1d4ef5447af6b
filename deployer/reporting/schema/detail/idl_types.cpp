// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Types where they are used.
#include "idl_number.hpp"
#include "idl_parser.hpp"
#include "limits.hpp"

#include <utility>

namespace oroforge::schema {
namespace {

constexpr std::pair<std::string_view, Basic> kBasics[] = {
    {"boolean", Basic::Bool}, {"octet", Basic::UInt8},   {"byte", Basic::UInt8},    {"char", Basic::UInt8},
    {"int8", Basic::Int8},    {"uint8", Basic::UInt8},   {"int16", Basic::Int16},   {"uint16", Basic::UInt16},
    {"int32", Basic::Int32},  {"uint32", Basic::UInt32}, {"int64", Basic::Int64},   {"uint64", Basic::UInt64},
    {"short", Basic::Int16},  {"float", Basic::Float32}, {"double", Basic::Float64}};

}  // namespace

bool IdlParser::type(IdlType& result) {
    if (++depth_ > kDeepest) return reader_.fail("types nest too deeply");
    if (!reader_.skipAnnotations()) return false;
    result.line = reader_.next().line;
    const bool isGood = basicType(result);
    --depth_;
    return isGood;
}

bool IdlParser::basicType(IdlType& result) {
    if (reader_.accept("sequence")) {
        if (!reader_.expect("<") || !type(result)) return false;
        result.lists.insert(result.lists.begin(), {true, 0});
        return (!reader_.accept(",") || limit()) && reader_.expect(">");
    }
    if (reader_.is("string") || reader_.is("wstring")) {
        result.basic = reader_.take().text == "string" ? Basic::Text : Basic::WideText;
        return !reader_.accept("<") || (limit() && reader_.expect(">"));
    }
    if (reader_.accept("wchar")) {
        result.basic = Basic::WideText;
        return true;
    }
    if (reader_.accept("unsigned")) {
        if (reader_.accept("short")) {
            result.basic = Basic::UInt16;
            return true;
        }
        if (!reader_.expect("long")) return false;
        result.basic = reader_.accept("long") ? Basic::UInt64 : Basic::UInt32;
        return true;
    }
    if (reader_.accept("long")) {
        if (reader_.is("double")) return reader_.fail("numbers of the type 'long double' are not read");
        result.basic = reader_.accept("long") ? Basic::Int64 : Basic::Int32;
        return true;
    }
    for (const auto& [name, basic] : kBasics) {
        if (!reader_.accept(name)) continue;
        result.basic = basic;
        return true;
    }
    for (const char* const other : {"map", "any", "fixed", "bitset", "bitmask", "struct", "union", "enum"})
        if (reader_.is(other)) return reader_.fail("fields of the type '" + std::string(other) + "' are not read");
    if (reader_.next().kind != IdlToken::Name || isIdlKeyword(reader_.next().text)) return reader_.failAt("a type");
    result.name = reader_.take().text;
    result.scope = scope_;
    return true;
}

/** The greatest number of elements, which does not matter here. */
bool IdlParser::limit() {
    std::int64_t most = 0;
    return readNumber(reader_, names_, scope_, most, true);
}

}  // namespace oroforge::schema
