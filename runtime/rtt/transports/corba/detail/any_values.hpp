// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_ANY_VALUES_HPP
#define ORO_CORBA_DETAIL_ANY_VALUES_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/transports/corba/corba.h>

#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}
namespace corba {

class CorbaTypeTransporter;

namespace detail {

/** Null if values of the type do not cross CORBA. */
const CorbaTypeTransporter* transporterOf(const types::TypeInfo& type);
/** The value of the last evaluation of `source`; an empty Any if it cannot be converted. The caller owns it. */
CORBA::Any* newAny(const base::DataSourceBase::shared_ptr& source);
/** The same into an Any that exists; false if it cannot be converted. */
bool put(const base::DataSourceBase::shared_ptr& source, CORBA::Any& any);
/** False if the types differ. */
bool assign(const CORBA::Any& any, const base::DataSourceBase::shared_ptr& target);
/** A new variable of that type; null if the types differ. */
base::DataSourceBase::shared_ptr valueOf(const CORBA::Any& any, const types::TypeInfo& type);
/** The type in an Any, for messages. */
std::string typeName(const CORBA::Any& any);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
