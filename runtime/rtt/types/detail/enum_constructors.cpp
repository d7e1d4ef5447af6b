// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "enum_constructors.hpp"

#include <rtt/types/TemplateConstructor.hpp>
#include <cstdlib>
#include <memory>
#include <string>

namespace RTT {
namespace types {
namespace detail {

namespace {
bool enumFromInt(const void* names, const void* const* arguments, void* result) {
    static_cast<const EnumNames*>(names)->ops.set(result, *static_cast<const int*>(arguments[0]));
    return true;
}

bool intFromEnum(const void* names, const void* const* arguments, void* result) {
    *static_cast<int*>(result) = static_cast<int>(static_cast<const EnumNames*>(names)->ops.get(arguments[0]));
    return true;
}

bool enumFromText(const void* names, const void* const* arguments, void* result) {
    const auto& known = *static_cast<const EnumNames*>(names);
    return known.set(*static_cast<const std::string*>(arguments[0]), result);
}

bool textFromEnum(const void* names, const void* const* arguments, void* result) {
    *static_cast<std::string*>(result) = static_cast<const EnumNames*>(names)->textOf(arguments[0]);
    return true;
}

ErasedFunction conversion(ComputeFunction call, const EnumNames& names, TypeRef result, TypeRef argument) {
    ErasedFunction function;
    function.call = call;
    function.context = std::make_shared<EnumNames>(names);
    function.result = result;
    function.arity = 1;
    function.arguments = {argument};
    return function;
}
}  // namespace

bool EnumNames::set(const std::string& text, void* value) const {
    for (std::size_t i = 0; i != count; ++i) {
        if (text != values[i].name) continue;
        ops.set(value, values[i].value);
        return true;
    }
    char* end = nullptr;
    const long long number = ops.isUnsigned ? static_cast<long long>(std::strtoull(text.c_str(), &end, 10))
                                            : std::strtoll(text.c_str(), &end, 10);
    if (end == text.c_str() || *end != '\0') return false;
    ops.set(value, number);
    return true;
}

std::string EnumNames::textOf(const void* value) const {
    const long long number = ops.get(value);
    for (std::size_t i = 0; i != count; ++i)
        if (values[i].value == number) return values[i].name;
    return ops.isUnsigned ? std::to_string(static_cast<unsigned long long>(number)) : std::to_string(number);
}

void addEnumConstructors(TypeInfo& info, TypeRef enumType, const EnumNames& names) {
    info.addConstructor(newErasedConstructor(conversion(&enumFromInt, names, enumType, &typeRef<int>), true));
    info.addConstructor(newErasedConstructor(conversion(&enumFromText, names, enumType, &typeRef<std::string>), true));
    if (TypeInfo* number = Types()->getTypeInfo<int>())
        number->addConstructor(newErasedConstructor(conversion(&intFromEnum, names, &typeRef<int>, enumType), true));
    if (TypeInfo* text = Types()->getTypeInfo<std::string>())
        text->addConstructor(
            newErasedConstructor(conversion(&textFromEnum, names, &typeRef<std::string>, enumType), false));
}

}  // namespace detail
}  // namespace types
}  // namespace RTT
