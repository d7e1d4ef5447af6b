// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The container itself; paths and updates are in internal/values.
#include "PropertyBag.hpp"

#include <rtt/base/PropertyIntrospection.hpp>
#include <rtt/types/member_update.hpp>
#include <algorithm>
#include <functional>
#include <ostream>

namespace RTT {

using base::PropertyBase;

PropertyBag::PropertyBag() : type("PropertyBag") {}

PropertyBag::PropertyBag(const std::string& t) : type(t) {}

PropertyBag::PropertyBag(const PropertyBag& other) : type(other.type) {
    mproperties.reserve(other.size());
    for (auto* property : other.mproperties) {
        if (other.ownsProperty(property))
            ownProperty(property->clone());
        else
            add(property);
    }
}

PropertyBag& PropertyBag::operator=(const PropertyBag& other) {
    if (&other == this) return *this;
    PropertyBag copied(other);
    mproperties.swap(copied.mproperties);
    mowned_props.swap(copied.mowned_props);
    type.swap(copied.type);
    return *this;
}

PropertyBag::~PropertyBag() { clear(); }

bool PropertyBag::addProperty(PropertyBase& property) {
    if (!property.ready()) return false;
    mproperties.push_back(&property);
    return true;
}

bool PropertyBag::ownProperty(PropertyBase* property) {
    if (!property || !property->ready()) return false;
    const auto at = std::lower_bound(mowned_props.begin(), mowned_props.end(), property, std::less<>());
    if (at != mowned_props.end() && *at == property) return true;
    // If the bag owns all, this one is not among them.
    const bool known = mowned_props.size() != mproperties.size() &&
                       std::find(mproperties.begin(), mproperties.end(), property) != mproperties.end();
    if (!known) mproperties.push_back(property);
    mowned_props.insert(at, property);
    return true;
}

bool PropertyBag::ownsProperty(const PropertyBase* property) const {
    return std::binary_search(mowned_props.begin(), mowned_props.end(), property, std::less<>());
}

bool PropertyBag::removeProperty(PropertyBase* property) {
    // From the end, because the last one added is usually removed first.
    const auto found = std::find(mproperties.rbegin(), mproperties.rend(), property);
    if (found == mproperties.rend()) return false;
    mproperties.erase(std::next(found).base());
    if (!ownsProperty(property)) return true;
    mowned_props.erase(std::lower_bound(mowned_props.begin(), mowned_props.end(), property, std::less<>()));
    mproperties.erase(std::remove(mproperties.begin(), mproperties.end(), property), mproperties.end());
    delete property;
    return true;
}

void PropertyBag::clear() {
    Properties owned;
    owned.swap(mowned_props);
    mproperties.clear();
    for (auto* property : owned) delete property;
}

PropertyBase* PropertyBag::find(const std::string& name) const {
    for (auto* property : mproperties)
        if (property->getName() == name) return property;
    return nullptr;
}

PropertyBag::Names PropertyBag::list() const {
    Names names;
    for (const auto* property : mproperties) names.push_back(property->getName());
    return names;
}

PropertyBag::Properties PropertyBag::getProperties(const std::string& name) const {
    Properties found;
    for (auto* property : mproperties)
        if (property->getName() == name) found.push_back(property);
    return found;
}

PropertyBase* PropertyBag::getItem(std::size_t index) const {
    return index < mproperties.size() ? mproperties[index] : nullptr;
}

void PropertyBag::identify(base::PropertyIntrospection* visitor) const {
    for (const auto* property : mproperties) property->identify(visitor);
}

PropertyBag& PropertyBag::operator<<=(const PropertyBag& source) {
    if (&source == this) return *this;
    for (auto* property : source.mproperties) {
        if (auto* mine = find(property->getName())) removeProperty(mine);
        add(property);
    }
    return *this;
}

std::ostream& operator<<(std::ostream& os, const PropertyBag& bag) {
    os << "[[";
    for (auto* property : bag) os << property->getName() << "='" << property << "'\n";
    return os << "]]";
}

namespace internal::detail {
bool composeFromBag(const PropertyBag& bag, base::DataSourceBase::shared_ptr target) {
    const base::DataSourceBase::shared_ptr source(new ConstReferenceDataSource<PropertyBag>(bag));
    return types::detail::updateWithConversion(target, source);
}
}  // namespace internal::detail

}  // namespace RTT
