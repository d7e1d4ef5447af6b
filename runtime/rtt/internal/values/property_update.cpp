// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "property_update.hpp"

#include <rtt/Logger.hpp>
#include <diag/nearest_match.hpp>
#include <rtt/internal/values/newer_properties.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/member_update.hpp>
#include <algorithm>
#include <exception>
#include <memory>

namespace diag = oroforge::diag;

namespace RTT::internal::detail {

using base::PropertyBase;

namespace {

bool isPlainBagType(const std::string& type) { return type.empty() || type == "PropertyBag" || type == "type_less"; }

/** The way from the outermost bag to a property, for messages. */
struct Trail {
    const Trail* outer;
    const PropertyBase& property;
    std::size_t index = 0;  // in place of an empty name

    std::string path() const {
        return (outer ? outer->path() + '.' : std::string()) +
               (property.getName().empty() ? std::to_string(index) : property.getName());
    }
    Trail within(const PropertyBase& inner, std::size_t at) const { return {this, inner, at}; }
};

std::string pathOf(const Trail* outer, const PropertyBase& property) { return Trail{outer, property}.path(); }

/** Assigns, converts or composes the value. One that throws has failed. */
bool setValue(const base::DataSourceBase::shared_ptr& target, const base::DataSourceBase::shared_ptr& source) {
    try {
        return types::detail::updateWithConversion(target, source);
    } catch (const std::exception&) {
        return false;
    }
}

bool updateAt(PropertyBase& target, const PropertyBase& source, const BagUpdate& how, const Trail* outer);

bool refreshItems(PropertyBag& target, const PropertyBag& source, const BagUpdate& how, const Trail* outer) {
    bool good = true;
    NamePairing pairing(source);
    for (std::size_t i = 0; i != target.size(); ++i) {
        PropertyBase* item = target.getItem(i);
        const std::string& name = item->getName();
        const PropertyBase* from = source.getItem(name.empty() ? i : pairing.next(name));
        if (from) {
            good = updateAt(*item, *from, how, outer) && good;
        } else if (how.needAll && !NewerProperties::has(target, name)) {
            how.report(nullptr, "property '" + pathOf(outer, *item) + "' of type " + item->getType() + " is missing");
            good = false;
        }
    }
    return good;
}

/** True if a bag of type `name` may become a value of the target's type. */
bool mayBecome(const std::string& name, const PropertyBase& target) {
    if (isPlainBagType(name) || name == "Sequence") return true;
    const types::TypeInfo* type = types::Types()->type(name);
    return type && type == target.getTypeInfo();
}

/** A copy of the item; bags that name a type become a value of that type. Null, with a report, if that fails. */
PropertyBase* newItem(const PropertyBase& item, const BagUpdate& how) {
    const PropertyBag* bag = bagOf(item);
    if (!bag || bag->getType() == "Sequence") return item.clone();
    if (isPlainBagType(bag->getType())) {
        auto made = std::make_unique<Property<PropertyBag>>(item.getName(), item.getDescription());
        made->value().setType(bag->getType());
        return addCopies(made->value(), *bag, how) ? made.release() : nullptr;
    }
    const types::TypeInfo* type = types::Types()->type(bag->getType());
    PropertyBase* made = type ? type->buildProperty(item.getName(), item.getDescription()) : nullptr;
    if (made && setValue(made->getDataSource(), item.getDataSource())) return made;
    delete made;
    how.report(&item, "property '" + item.getName() + "' cannot be made: type " + bag->getType() +
                          (type ? " cannot be composed from these members" : " is not known to any typekit"));
    return nullptr;
}

bool addMissingItems(PropertyBag& target, const PropertyBag& source, const BagUpdate& how) {
    NamePairing pairing(target);
    bool good = true;
    const std::size_t had = target.size();
    for (std::size_t i = 0; i != source.size(); ++i) {
        const PropertyBase* item = source.getItem(i);
        const std::size_t known = item->getName().empty() ? i : pairing.next(item->getName());
        if (known >= had) good = target.ownProperty(newItem(*item, how)) && good;
    }
    return good;
}

bool updateBagAt(PropertyBag& target, const PropertyBag& source, const BagUpdate& how, const Trail* outer) {
    const bool good = refreshItems(target, source, how, outer);
    return (!how.addMissing || addMissingItems(target, source, how)) && good;
}

/** True if elements of the type have no names. */
bool isSequence(const types::TypeInfo& type) {
    const auto names = type.getMemberNames();
    return std::find(names.begin(), names.end(), "capacity") != names.end();
}

std::string quotedValue(const base::DataSourceBase::shared_ptr& source) { return "'" + source->toString() + "'"; }

/** Why a value that is not a bag is refused: " cannot …". */
std::string refusal(const types::TypeInfo* type, const PropertyBase& source) {
    const types::Enumeration* const values = types::detail::enumerationOf(type);
    const auto given = source.getDataSource();
    const bool isText = source.getType() == "string";
    if (values && !values->enumerators().empty() && (isText || types::detail::wholeNumberIn(given))) {
        const std::vector<std::string> names = values->enumerators();
        return " cannot be " + quotedValue(given) + "; expected " + diag::oneOf(names) +
               (isText ? diag::didYouMean(given->toString(), names) : std::string());
    }
    return " cannot take a value of type " + source.getType();
}

/** Reports the given members that do not fit `type`; false if all of them fit. */
bool reportMembers(const types::TypeInfo& type, const PropertyBag& members, const BagUpdate& how, const Trail& trail) {
    // Every member is tried on a new value.
    const auto value = type.buildValue();
    if (!value) return false;
    const std::size_t first = isSequence(type) ? types::detail::firstElement(members) : 0;
    type.resize(value, static_cast<int>(members.size() - first));
    bool reported = false;
    for (std::size_t i = first; i != members.size(); ++i) {
        const PropertyBase& item = *members.getItem(i);
        auto member = item.getName().empty() ? nullptr : value->getMember(item.getName());
        if (!member) member = value->getMember(std::to_string(i - first));
        if (!member) continue;
        const Trail here = trail.within(item, i);
        const PropertyBag* bag = bagOf(item);
        if (bag && reportMembers(*member->getTypeInfo(), *bag, how, here)) {
            reported = true;
        } else if (!setValue(member, item.getDataSource())) {
            reported = true;
            how.report(&item,
                       "property '" + here.path() + "' of type " + member->getTypeName() +
                           (bag ? " cannot be filled from the members given" : refusal(member->getTypeInfo(), item)));
        }
    }
    return reported;
}

void reportMismatch(const PropertyBase& target, const PropertyBase& source, const BagUpdate& how, const Trail& trail) {
    const PropertyBag* bag = bagOf(source);
    const std::string start = "property '" + trail.path() + "' of type " + target.getType();
    if (!bag) {
        how.report(&source, start + refusal(target.getTypeInfo(), source));
    } else if (!mayBecome(bag->getType(), target)) {
        how.report(&source, start + " cannot take a value of type " + bag->getType() +
                                (types::Types()->type(bag->getType()) ? "" : ", which no typekit knows"));
    } else if (!target.getTypeInfo() || !reportMembers(*target.getTypeInfo(), *bag, how, trail)) {
        how.report(&source, start + " cannot be filled from the members given");
    }
}

bool updateAt(PropertyBase& target, const PropertyBase& source, const BagUpdate& how, const Trail* outer) {
    if (how.fillDescriptions && target.getDescription().empty()) target.setDescription(source.getDescription());
    const Trail trail{outer, target};
    PropertyBag* targetBag = bagOf(target);
    const PropertyBag* sourceBag = bagOf(source);
    if (targetBag && sourceBag) {
        if (!isPlainBagType(targetBag->getType()) && targetBag->getType() != sourceBag->getType()) {
            how.report(&source, "property bag '" + trail.path() + "' of type " + targetBag->getType() +
                                    " cannot be filled from one of type " + sourceBag->getType());
            return false;
        }
        const bool good = updateBagAt(*targetBag, *sourceBag, how, &trail);
        target.getDataSource()->updated();
        return good;
    }
    const bool allowed = !sourceBag || mayBecome(sourceBag->getType(), target);
    if (allowed && setValue(target.getDataSource(), source.getDataSource())) return true;
    reportMismatch(target, source, how, trail);
    return false;
}

}  // namespace

void logUpdateError(const PropertyBase*, const std::string& text) { log(Error) << text << endlog(); }

bool addCopies(PropertyBag& target, const PropertyBag& source, const BagUpdate& how) {
    bool good = true;
    for (const auto* item : source) good = target.ownProperty(newItem(*item, how)) && good;
    return good;
}

PropertyBag* bagOf(const PropertyBase& property) {
    const auto source = property.getDataSource();
    if (!source || !source->getTypeId() || *source->getTypeId() != typeid(PropertyBag)) return nullptr;
    return static_cast<PropertyBag*>(source->getRawPointer());
}

NamePairing::NamePairing(const PropertyBag& bag) : followers_(bag.size()) {
    heads_.reserve(bag.size());
    for (std::size_t i = bag.size(); i-- != 0;) {
        const auto added = heads_.emplace(bag.getItem(i)->getName(), i);
        followers_[i] = added.second ? bag.size() : added.first->second;
        added.first->second = i;
    }
}

std::size_t NamePairing::next(const std::string& name) {
    const auto found = heads_.find(name);
    if (found == heads_.end() || found->second == followers_.size()) return followers_.size();
    const std::size_t index = found->second;
    found->second = followers_[index];
    return index;
}

bool updateBag(PropertyBag& target, const PropertyBag& source, const BagUpdate& how) {
    return updateBagAt(target, source, how, nullptr);
}

bool updateOne(PropertyBase& target, const PropertyBase& source, const BagUpdate& how) {
    return updateAt(target, source, how, nullptr);
}

}  // namespace RTT::internal::detail
