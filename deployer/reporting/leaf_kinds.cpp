// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "leaf_kinds.hpp"

#include "record.hpp"

#include <rtt/rt_string.hpp>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace OCL::reporting {
namespace {

template <class T>
void append(T value, Record& record) {
    if constexpr (std::is_same_v<T, bool>)
        record.value(Tag::Bool, value);
    else if constexpr (std::is_same_v<T, char>)
        record.value(Tag::Char, value);
    else if constexpr (std::is_same_v<T, float>)
        record.value(Tag::Float, value);
    else if constexpr (std::is_floating_point_v<T>)
        record.value(Tag::Real, static_cast<double>(value));
    else if constexpr (std::is_signed_v<T>)
        record.value(Tag::Signed, static_cast<std::int64_t>(value));
    else
        record.value(Tag::Unsigned, static_cast<std::uint64_t>(value));
}

template <class T>
void encodeNumber(const void* value, Record& record) {
    append(*static_cast<const T*>(value), record);
}

template <class S>
void encodeText(const void* value, Record& record) {
    const S& text = *static_cast<const S*>(value);
    record.text(Tag::Text, std::string_view(text.data(), text.size()));
}

template <class T>
void encodeElements(const void* vector, Record& record) {
    for (const T element : *static_cast<const std::vector<T>*>(vector)) append(element, record);
}

template <class T>
std::size_t sizeOf(const void* vector) {
    return static_cast<const std::vector<T>*>(vector)->size();
}

template <class T>
constexpr Number numberKind() {
    if constexpr (std::is_same_v<T, bool>)
        return Number::Bool;
    else if constexpr (std::is_same_v<T, char>)
        return Number::Char;
    else if constexpr (std::is_same_v<T, float>)
        return Number::Float;
    else if constexpr (std::is_floating_point_v<T>)
        return Number::Real;
    else if constexpr (sizeof(T) == 1)
        return std::is_signed_v<T> ? Number::Int8 : Number::UInt8;
    else if constexpr (sizeof(T) == 2)
        return std::is_signed_v<T> ? Number::Int16 : Number::UInt16;
    else if constexpr (sizeof(T) == 4)
        return std::is_signed_v<T> ? Number::Int32 : Number::UInt32;
    else
        return std::is_signed_v<T> ? Number::Int64 : Number::UInt64;
}

struct Kind {
    const std::type_info& type;
    Encode encode;
    Number number;
    const std::type_info* vectorType;
    NumberVector vector;
};

template <class T>
Kind number() {
    constexpr Number kind = numberKind<T>();
    return {typeid(T), &encodeNumber<T>, kind, &typeid(std::vector<T>), {&encodeElements<T>, &sizeOf<T>, kind}};
}
template <class S>
Kind text() {
    return {typeid(S), &encodeText<S>, Number::Text, nullptr, {}};
}

const Kind kKinds[] = {
    number<double>(),      number<float>(),
    number<bool>(),        number<char>(),
    number<signed char>(), number<unsigned char>(),
    number<short>(),       number<unsigned short>(),
    number<int>(),         number<unsigned>(),
    number<long>(),        number<unsigned long>(),
    number<long long>(),   number<unsigned long long>(),
    text<std::string>(),   text<RTT::rt_string>(),
};

// Compares names, because plugins may have different type_info objects of one type.
bool same(const std::type_info& one, const std::type_info& other) { return std::strcmp(one.name(), other.name()) == 0; }

}  // namespace

Encode encodeOf(const std::type_info& type) {
    for (const Kind& kind : kKinds)
        if (same(kind.type, type)) return kind.encode;
    return nullptr;
}

Number numberOf(const std::type_info& type) {
    for (const Kind& kind : kKinds)
        if (same(kind.type, type)) return kind.number;
    return Number::Text;
}

const NumberVector* numberVectorOf(const std::type_info& type) {
    for (const Kind& kind : kKinds)
        if (kind.vectorType && same(*kind.vectorType, type)) return &kind.vector;
    return nullptr;
}

}  // namespace OCL::reporting
