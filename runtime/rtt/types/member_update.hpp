// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MEMBER_UPDATE_HPP
#define ORO_MEMBER_UPDATE_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <optional>

namespace RTT {
class PropertyBag;
namespace types {

class TypeInfo;
class Enumeration;

namespace detail {

/** The object registered for that C++ type, or a new one of that name. */
RTT_API TypeInfo* knownOrNewType(const std::string& name, const std::type_info& id);

/** The values of an enum; null for other types. */
RTT_API const Enumeration* enumerationOf(const TypeInfo* type);
/** The integer that the source or its text has. */
RTT_API std::optional<long long> wholeNumberIn(const base::DataSourceBase::shared_ptr& source);

/** Sets `target` from `source` by assignment, conversion or composition. An enum does not accept numbers other than its
    values. */
RTT_API bool updateWithConversion(base::DataSourceBase::shared_ptr target, base::DataSourceBase::shared_ptr source);

/** The value of the member "size"; -1 if there is none. */
int elementCount(const base::DataSourceBase::shared_ptr& source);
/** The member of that index, or null. */
base::DataSourceBase::shared_ptr elementOf(const base::DataSourceBase::shared_ptr& source, int index);
/** True for a string: it consists of letters, and can be written and read back as text. */
bool isText(const base::DataSourceBase::shared_ptr& source);
/** The index of the first element of a sequence in its bag: old property files put the item "Size" before it. */
std::size_t firstElement(const PropertyBag& bag);

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
