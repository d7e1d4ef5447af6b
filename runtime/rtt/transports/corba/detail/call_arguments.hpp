// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_CALL_ARGUMENTS_HPP
#define ORO_CORBA_DETAIL_CALL_ARGUMENTS_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/transports/corba/OperationInterfaceC.h>
#include <rtt/transports/corba/corba.h>

namespace RTT {
namespace corba {
namespace detail {

/** The arguments of a call as variables. Throws CWrongNumbArgException and CWrongTypeArgException. */
OperationInterfacePart::Args argumentsOf(const internal::OperationSignature& signature, const CAnyArguments& values);
/** A variable for each value that a sent call gives. */
OperationInterfacePart::Args collectedBy(const OperationInterfacePart& part);
/** The values of variables. */
void setValues(CAnyArguments& values, const OperationInterfacePart::Args& from);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
