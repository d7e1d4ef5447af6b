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

/** What is known of the values of that type; null if it is no enum. */
RTT_API const Enumeration* enumerationOf(const TypeInfo* type);
/** The number that the source holds, or its text spells. */
RTT_API std::optional<long long> wholeNumberIn(const base::DataSourceBase::shared_ptr& source);

/** Sets `target` from `source` whatever way there is: assignment, conversion, composition. An enum takes no number that is none of
    its values. */
RTT_API bool updateByAnyMeans(base::DataSourceBase::shared_ptr target, base::DataSourceBase::shared_ptr source);

/** The value of the member "size"; -1 if there is none. */
int elementCount(const base::DataSourceBase::shared_ptr& source);
/** The member of that index, or null. */
base::DataSourceBase::shared_ptr elementOf(const base::DataSourceBase::shared_ptr& source, int index);
/** True for a string: it can be written and read back as text, and is made of letters. */
bool isText(const base::DataSourceBase::shared_ptr& source);
/** Where the elements of a sequence begin in its bag: behind their number, called "Size", that old property files put in
    front of them. */
std::size_t firstElement(const PropertyBag& bag);

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
