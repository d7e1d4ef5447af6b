// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "classic_header.hpp"

namespace OCL::reporting {
namespace {

constexpr std::uint32_t kDimensions = 0x0A, kVariables = 0x0B, kAttributes = 0x0C;

void put32(std::string& bytes, std::uint32_t number) { appendBig(bytes, ClassicType::UInt, number); }
void put64(std::string& bytes, std::uint64_t number) { appendBig(bytes, ClassicType::UInt64, number); }

void putPadded(std::string& bytes, const std::string& value) {
    bytes += value;
    bytes.append((4 - value.size() % 4) % 4, '\0');
}

void putName(std::string& bytes, const std::string& name) {
    put64(bytes, name.size());
    putPadded(bytes, name);
}

/** An empty list has no tag. */
void putListHead(std::string& bytes, std::uint32_t tag, std::size_t count) {
    put32(bytes, count == 0 ? 0 : tag);
    put64(bytes, count);
}

void putAttributes(std::string& bytes, const std::vector<ClassicAttribute>& attributes) {
    putListHead(bytes, kAttributes, attributes.size());
    for (const ClassicAttribute& attribute : attributes) {
        putName(bytes, attribute.name);
        put32(bytes, static_cast<std::uint32_t>(attribute.type));
        put64(bytes, attribute.values.size() / sizeOf(attribute.type));
        putPadded(bytes, attribute.values);
    }
}

}  // namespace

std::size_t sizeOf(ClassicType type) {
    switch (type) {
        case ClassicType::Byte:
        case ClassicType::Char:
        case ClassicType::UByte: return 1;
        case ClassicType::Short:
        case ClassicType::UShort: return 2;
        case ClassicType::Int:
        case ClassicType::UInt:
        case ClassicType::Float: return 4;
        case ClassicType::Double:
        case ClassicType::Int64:
        case ClassicType::UInt64: break;
    }
    return 8;
}

void appendBig(std::string& bytes, ClassicType type, std::uint64_t number) {
    for (std::size_t i = sizeOf(type); i-- != 0;) bytes.push_back(static_cast<char>(number >> (8 * i)));
}

std::string fillOf(ClassicType type) {
    constexpr std::uint64_t kFloat = 0x7CF00000, kDouble = 0x479E000000000000;  // 9.969209968386869e36
    std::string bytes;
    switch (type) {
        case ClassicType::Byte: appendBig(bytes, type, static_cast<std::uint64_t>(-127)); break;
        case ClassicType::Char: appendBig(bytes, type, 0); break;
        case ClassicType::Short: appendBig(bytes, type, static_cast<std::uint64_t>(-32767)); break;
        case ClassicType::Int: appendBig(bytes, type, static_cast<std::uint64_t>(-2147483647)); break;
        case ClassicType::Float: appendBig(bytes, type, kFloat); break;
        case ClassicType::Double: appendBig(bytes, type, kDouble); break;
        case ClassicType::UByte: appendBig(bytes, type, 255); break;
        case ClassicType::UShort: appendBig(bytes, type, 65535); break;
        case ClassicType::UInt: appendBig(bytes, type, 4294967295U); break;
        case ClassicType::Int64: appendBig(bytes, type, static_cast<std::uint64_t>(-9223372036854775806)); break;
        case ClassicType::UInt64: appendBig(bytes, type, 18446744073709551614U); break;
    }
    return bytes;
}

std::string classicHeader(const std::vector<ClassicVariable>& variables,
                          const std::vector<ClassicAttribute>& attributes) {
    constexpr std::uint64_t kUnlimited = 0;
    std::string bytes = "CDF\x05";
    put64(bytes, 0);  // records
    std::uint64_t dimensions = 1;
    for (const ClassicVariable& variable : variables) dimensions += !variable.dimension.empty();
    putListHead(bytes, kDimensions, dimensions);
    putName(bytes, "time");
    put64(bytes, kUnlimited);
    for (const ClassicVariable& variable : variables) {
        if (variable.dimension.empty()) continue;
        putName(bytes, variable.dimension);
        put64(bytes, variable.elements);
    }
    putAttributes(bytes, attributes);
    putListHead(bytes, kVariables, variables.size());
    std::vector<std::size_t> begins;  // places of the numbers that tell where a variable begins
    std::uint64_t dimension = 0;
    for (const ClassicVariable& variable : variables) {
        putName(bytes, variable.name);
        put64(bytes, variable.dimension.empty() ? 1 : 2);
        put64(bytes, 0);
        if (!variable.dimension.empty()) put64(bytes, ++dimension);
        putAttributes(bytes, variable.attributes);
        put32(bytes, static_cast<std::uint32_t>(variable.type));
        put64(bytes, variable.bytes());
        begins.push_back(bytes.size());
        put64(bytes, 0);
    }
    std::uint64_t begin = bytes.size();
    for (std::size_t i = 0; i != variables.size(); ++i) {
        std::string number;
        put64(number, begin);
        bytes.replace(begins[i], number.size(), number);
        begin += variables[i].bytes();
    }
    return bytes;
}

}  // namespace OCL::reporting
