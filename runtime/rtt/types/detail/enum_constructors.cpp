// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "enum_constructors.hpp"

#include <rtt/types/TemplateConstructor.hpp>
#include <memory>

namespace RTT {
namespace types {
namespace detail {

namespace {
bool enumFromInt(const void* numbers, const void* const* arguments, void* result) {
    static_cast<const EnumOps*>(numbers)->set(result, *static_cast<const int*>(arguments[0]));
    return true;
}

bool intFromEnum(const void* numbers, const void* const* arguments, void* result) {
    *static_cast<int*>(result) = static_cast<int>(static_cast<const EnumOps*>(numbers)->get(arguments[0]));
    return true;
}

ErasedFunction conversion(ComputeFunction call, const EnumOps& numbers, TypeRef result, TypeRef argument) {
    ErasedFunction function;
    function.call = call;
    function.context = std::shared_ptr<const void>(&numbers, [](const void*) {});
    function.result = result;
    function.arity = 1;
    function.arguments = {argument};
    return function;
}
}  // namespace

void addEnumConstructors(TypeInfo& info, TypeRef enumType, const EnumOps& numbers) {
    info.addConstructor(newErasedConstructor(conversion(&enumFromInt, numbers, enumType, &typeRef<int>), true));
    if (TypeInfo* number = Types()->getTypeInfo<int>())
        number->addConstructor(newErasedConstructor(conversion(&intFromEnum, numbers, &typeRef<int>, enumType), true));
}

}  // namespace detail
}  // namespace types
}  // namespace RTT
