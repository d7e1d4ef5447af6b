// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/call_arguments.hpp>

#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <utility>

namespace RTT::corba::detail {

OperationInterfacePart::Args argumentsOf(const internal::OperationSignature& signature, const CAnyArguments& values) {
    const std::size_t arity = signature.arguments.size();
    if (values.length() != arity)
        throw CWrongNumbArgException(static_cast<CORBA::Long>(arity), static_cast<CORBA::Long>(values.length()));
    OperationInterfacePart::Args made;
    made.reserve(arity);
    for (CORBA::ULong i = 0; i != arity; ++i) {
        const types::TypeInfo* const type = signature.arguments[i].type;
        base::DataSourceBase::shared_ptr value = type ? valueOf(values[i], *type) : nullptr;
        if (!value)
            throw CWrongTypeArgException(static_cast<CORBA::Long>(i + 1),
                                         type ? type->getTypeName().c_str() : "unknown_t", typeName(values[i]).c_str());
        made.push_back(std::move(value));
    }
    return made;
}

OperationInterfacePart::Args collectedBy(const OperationInterfacePart& part) {
    OperationInterfacePart::Args made;
    for (unsigned i = 1; i <= part.collectArity(); ++i) {
        const types::TypeInfo* const type = part.getCollectType(i);
        made.push_back(type ? type->buildValue() : nullptr);
    }
    return made;
}

void setValues(CAnyArguments& values, const OperationInterfacePart::Args& from) {
    values.length(static_cast<CORBA::ULong>(from.size()));
    for (CORBA::ULong i = 0; i != values.length(); ++i) {
        if (!put(from[i], values[i])) values[i] = CORBA::Any();
    }
}

}  // namespace RTT::corba::detail
