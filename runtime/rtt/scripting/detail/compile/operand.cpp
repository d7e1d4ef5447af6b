// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/operand.hpp>

#include <rtt/internal/DataSources.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <typeinfo>

namespace RTT::scripting::detail {

namespace {

constexpr const char* names[] = {"bool", "char", "int", "uint", "llong", "ullong", "float", "double"};

template <class T>
const void* addressIn(base::DataSourceBase& source) {
    using namespace internal;
    const std::type_info& type = typeid(source);
    if (type == typeid(ValueDataSource<T>) || type == typeid(UnboundDataSource<ValueDataSource<T>>) ||
        type == typeid(ConstantDataSource<T>) || type == typeid(ReferenceDataSource<T>) ||
        type == typeid(ConstReferenceDataSource<T>))
        return source.getRawConstPointer();
    return nullptr;
}

}  // namespace

bool isSmallNumber(const Operand& operand) {
    return operand.kind == Kind::Other && operand.source && isDirect(widened(operand.source->getTypeId()));
}

bool isEnum(const types::TypeInfo* type) {
    return type && dynamic_cast<const types::Enumeration*>(type->getCompositionFactory().get());
}

std::string typeName(const Operand& operand) {
    if (operand.kind == Kind::None) return "void";
    if (operand.sent) return "SendHandle";
    return isDirect(operand.kind) ? names[static_cast<int>(operand.kind)] : operand.source->getTypeName();
}

const void* fixedAddress(base::DataSourceBase& source, Kind kind) {
    return withType(kind, [&](auto type) { return addressIn<typename decltype(type)::type>(source); });
}

}  // namespace RTT::scripting::detail
