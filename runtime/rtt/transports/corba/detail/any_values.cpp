// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/any_values.hpp>

#include <rtt/transports/corba/CorbaTypeTransporter.hpp>
#include <rtt/transports/corba/detail/generic_transporter.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <memory>
#include <typeinfo>

namespace RTT::corba::detail {

const CorbaTypeTransporter* transporterOf(const types::TypeInfo& type) {
    if (!type.hasProtocol(ORO_CORBA_PROTOCOL_ID)) return nullptr;
    const types::TypeTransporter* const found = type.getProtocol(ORO_CORBA_PROTOCOL_ID);
    // Most are of this one class, for which a cast without a search does.
    if (found && typeid(*found) == typeid(GenericTransporter)) return static_cast<const GenericTransporter*>(found);
    return dynamic_cast<const CorbaTypeTransporter*>(found);
}

CORBA::Any* newAny(const base::DataSourceBase::shared_ptr& source) {
    const CorbaTypeTransporter* const own = source ? transporterOf(*source->getTypeInfo()) : nullptr;
    CORBA::Any* const made = own ? own->createAny(source) : nullptr;
    return made ? made : new CORBA::Any();
}

bool put(const base::DataSourceBase::shared_ptr& source, CORBA::Any& any) {
    const CorbaTypeTransporter* const own = source ? transporterOf(*source->getTypeInfo()) : nullptr;
    return own && own->updateAny(source, any);
}

bool assign(const CORBA::Any& any, const base::DataSourceBase::shared_ptr& target) {
    const CorbaTypeTransporter* const own = target ? transporterOf(*target->getTypeInfo()) : nullptr;
    return own && own->updateFromAny(&any, target);
}

base::DataSourceBase::shared_ptr valueOf(const CORBA::Any& any, const types::TypeInfo& type) {
    const CorbaTypeTransporter* const own = transporterOf(type);
    return own ? own->createDataSource(&any) : nullptr;
}

std::string typeName(const CORBA::Any& any) {
    const CORBA::TypeCode_ptr type = any.NP_type();
    switch (type->kind()) {
        case CORBA::tk_null:
        case CORBA::tk_void: return "nothing";
        case CORBA::tk_boolean: return "bool";
        case CORBA::tk_char: return "char";
        case CORBA::tk_octet: return "octet";
        case CORBA::tk_short: return "short";
        case CORBA::tk_ushort: return "unsigned short";
        case CORBA::tk_long: return "long";
        case CORBA::tk_ulong: return "unsigned long";
        case CORBA::tk_longlong: return "long long";
        case CORBA::tk_ulonglong: return "unsigned long long";
        case CORBA::tk_float: return "float";
        case CORBA::tk_double: return "double";
        case CORBA::tk_string: return "string";
        case CORBA::tk_sequence: return "a sequence";
        case CORBA::tk_array: return "an array";
        case CORBA::tk_alias:
        case CORBA::tk_struct:
        case CORBA::tk_union:
        case CORBA::tk_enum:
        case CORBA::tk_objref: return type->name();
        default: return "another type";
    }
}

}  // namespace RTT::corba::detail
