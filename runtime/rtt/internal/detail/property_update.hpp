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
    bool addMissing = false;        ///< create in the target what it lacks
    bool needAll = false;           ///< it is an error if the source lacks something of the target
    bool fillDescriptions = false;  ///< take over descriptions where the target has none
    /** Called for each error; `where` is the property of the source, or null if that is what is missing. */
    std::function<void(const base::PropertyBase* where, const std::string& text)> report;
};

/** Finds properties by name, those of equal names in the order in which they appear. */
class RTT_API NamePairing {
public:
    /** Uses the names in `bag` while it lives. */
    explicit NamePairing(const PropertyBag& bag);
    /** Index of the next property of that name in the bag as it was; beyond its end if there is none left. */
    std::size_t next(const std::string& name);

private:
    std::unordered_map<std::string_view, std::size_t> heads_;
    std::vector<std::size_t> followers_;
};

/** Writes the text to the log, as an error. */
void logUpdateError(const base::PropertyBase* where, const std::string& text);

/** Goes on after errors, so that all are reported; false if there was one. */
RTT_API bool updateBag(PropertyBag& target, const PropertyBag& source, const BagUpdate& how);
RTT_API bool updateOne(base::PropertyBase& target, const base::PropertyBase& source, const BagUpdate& how);

/** Adds a copy of each item; bags that name a registered type become values of it. */
RTT_API bool addCopies(PropertyBag& target, const PropertyBag& source, const BagUpdate& how);

/** The bag behind a property of type PropertyBag, or null. */
RTT_API PropertyBag* bagOf(const base::PropertyBase& property);

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
