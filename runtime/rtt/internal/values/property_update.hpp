// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_UPDATE_HPP
#define ORO_PROPERTY_UPDATE_HPP

#include <rtt/PropertyBag.hpp>
#include <functional>
#include <string_view>
#include <unordered_map>

namespace RTT {
namespace internal {
namespace detail {

/** How one bag takes over the values of another. */
struct BagUpdate {
    bool addMissing = false;        ///< create items that the target lacks
    bool needAll = false;           ///< an item of the target that the source lacks is an error
    bool fillDescriptions = false;  ///< copy descriptions where the target has none
    /** Called for each error; `where` is the property of the source, or null if the source lacks it. */
    std::function<void(const base::PropertyBase* where, const std::string& text)> report;
};

/** Finds properties by name, and those of equal names in order. */
class RTT_API NamePairing {
public:
    /** Uses the names in `bag`, which must outlive it. */
    explicit NamePairing(const PropertyBag& bag);
    /** The index of the next property of that name in the original bag; beyond its end if there is none left. */
    std::size_t next(const std::string& name);

private:
    std::unordered_map<std::string_view, std::size_t> heads_;
    std::vector<std::size_t> followers_;
};

/** Logs the text as an error. */
void logUpdateError(const base::PropertyBase* where, const std::string& text);

/** Continue after errors, so that all are reported; false if there was one. */
RTT_API bool updateBag(PropertyBag& target, const PropertyBag& source, const BagUpdate& how);
RTT_API bool updateOne(base::PropertyBase& target, const base::PropertyBase& source, const BagUpdate& how);

/** Adds a copy of each item; bags that name a registered type become values of it. */
RTT_API bool addCopies(PropertyBag& target, const PropertyBag& source, const BagUpdate& how);

/** The value of a property of type PropertyBag; null for other types. */
RTT_API PropertyBag* bagOf(const base::PropertyBase& property);

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
