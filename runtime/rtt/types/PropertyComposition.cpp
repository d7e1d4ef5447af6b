// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "PropertyComposition.hpp"

#include <rtt/Logger.hpp>
#include <rtt/internal/values/property_update.hpp>
#include "PropertyDecomposition.hpp"
#include "Types.hpp"
#include <rtt/types/member_update.hpp>

namespace RTT::types {

using base::DataSourceBase;
using base::PropertyBase;

namespace {

/** `source`, or a copy if it cannot be changed, because parts of a copy can, which distinguishes them from computed
    members. */
DataSourceBase::shared_ptr assignable(const DataSourceBase::shared_ptr& source) {
    const auto copy = source->isAssignable() ? nullptr : source->getTypeInfo()->buildValue();
    return copy && copy->update(source.get()) ? copy : source;
}

/** The members of a value as a bag, by its type or with one property per member; null if it has none. */
DataSourceBase::shared_ptr membersOf(const DataSourceBase::shared_ptr& source) {
    const TypeInfo* type = source->getTypeInfo();
    if (auto decomposed = type->decomposeType(source)) return decomposed;
    const auto names = type->getMemberNames();
    // The letters of a string are not members.
    if (names.empty() || detail::isText(source)) return nullptr;
    boost::intrusive_ptr<internal::ValueDataSource<PropertyBag>> result(new internal::ValueDataSource<PropertyBag>());
    PropertyBag& bag = result->set();
    bag.setType(type->getTypeName());
    const auto add = [&bag](const std::string& name, const char* description, const DataSourceBase::shared_ptr& part) {
        return part && bag.ownProperty(part->getTypeInfo()->buildProperty(name, description, part));
    };
    const auto whole = assignable(source);
    for (const auto& name : names) {
        const auto member = whole->getMember(name);
        // Computed members, such as the size of a container, are not part of the value.
        if (member && member->isAssignable()) add(name, "Part", member);
    }
    const int count = bag.empty() ? detail::elementCount(whole) : 0;
    // All members are computed, so only the text has the value.
    if (count < 0 && type->isStreamable()) return nullptr;
    for (int i = 0; i < count; ++i)
        if (!add("Element" + std::to_string(i), "Sequence Element", detail::elementOf(whole, i))) return nullptr;
    return result;
}

/** Logs errors and returns false if the target has properties with names of `source`. */
bool hasRoomFor(const PropertyBag& source, const PropertyBag& target) {
    bool free = true;
    for (const PropertyBase* item : source) {
        if (item->getName().empty() || !target.find(item->getName())) continue;
        log(Error) << "the bag has a property '" << item->getName() << "' already; nothing is added" << endlog();
        free = false;
    }
    return free;
}

const PropertyBag* bagIn(const DataSourceBase::shared_ptr& source) {
    if (!source || !source->getTypeId() || *source->getTypeId() != typeid(PropertyBag)) return nullptr;
    return static_cast<const PropertyBag*>(source->getRawConstPointer());
}

/** Adds a property for `item` to `target`: a bag of its members if it has any, otherwise a property of the same
    value. */
bool addDecomposed(PropertyBase& item, PropertyBag& target, bool recurse) {
    const auto value = item.getDataSource();
    const auto simpler = recurse && !internal::detail::bagOf(item) ? membersOf(value) : nullptr;
    if (!simpler) return target.ownProperty(item.create(value));
    if (!bagIn(simpler))
        return target.ownProperty(
            simpler->getTypeInfo()->buildProperty(item.getName(), item.getDescription(), simpler));
    auto* made = new Property<PropertyBag>(item.getName(), item.getDescription());
    target.ownProperty(made);
    return typeDecomposition(value, made->value(), recurse);
}

}  // namespace

bool typeDecomposition(DataSourceBase::shared_ptr source, PropertyBag& target, bool recurse) {
    if (!source || bagIn(source)) return false;
    const auto members = membersOf(source);
    const PropertyBag* bag = bagIn(members);
    if (!bag) return false;
    target.setType(bag->getType());
    bool good = true;
    for (auto* item : *bag) good = addDecomposed(*item, target, recurse) && good;
    return good;
}

bool propertyDecomposition(PropertyBase* source, PropertyBag& target, bool recurse) {
    return source && source->ready() && typeDecomposition(source->getDataSource(), target, recurse);
}

bool decomposePropertyBag(const PropertyBag& source, PropertyBag& target) {
    if (!hasRoomFor(source, target)) return false;
    target.setType(source.getType());
    bool good = true;
    for (auto* item : source) {
        const PropertyBag* inner = internal::detail::bagOf(*item);
        if (!inner) {
            good = addDecomposed(*item, target, true) && good;
            continue;
        }
        auto* made = new Property<PropertyBag>(item->getName(), item->getDescription());
        target.ownProperty(made);
        good = decomposePropertyBag(*inner, made->value()) && good;
    }
    return good;
}

bool composePropertyBag(const PropertyBag& source, PropertyBag& target) {
    if (!hasRoomFor(source, target)) return false;
    internal::detail::BagUpdate how;
    how.report = internal::detail::logUpdateError;
    target.setType(source.getType());
    return internal::detail::addCopies(target, source, how);
}

}  // namespace RTT::types
