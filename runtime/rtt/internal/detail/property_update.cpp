// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "property_update.hpp"

#include <rtt/Logger.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/detail/member_update.hpp>
#include <map>
#include <memory>

namespace RTT {
namespace internal {
namespace detail {

using base::PropertyBase;

namespace {

bool isPlainBagType(const std::string& type) { return type.empty() || type == "PropertyBag" || type == "type_less"; }

/** Pairs properties of equal names in the order in which they appear. */
class Pairing {
public:
    PropertyBase* next(const PropertyBag& in, const std::string& name) {
        std::size_t& from = next_[name];
        for (std::size_t i = from; i != in.size(); ++i) {
            if (in.getItem(i)->getName() != name) continue;
            from = i + 1;
            return in.getItem(i);
        }
        from = in.size();
        return nullptr;
    }

private:
    std::map<std::string, std::size_t> next_;
};

bool refreshItems(PropertyBag& target, const PropertyBag& source, const BagUpdate& how) {
    bool good = true;
    Pairing pairing;
    for (std::size_t i = 0; i != target.size(); ++i) {
        PropertyBase* item = target.getItem(i);
        const std::string& name = item->getName();
        const PropertyBase* from = name.empty() ? source.getItem(i) : pairing.next(source, name);
        if (from) {
            good = updateOne(*item, *from, how) && good;
        } else if (how.needAll) {
            how.report(nullptr, "property '" + name + "' of type " + item->getType() + " is missing");
            good = false;
        }
    }
    return good;
}

/** True if a bag of type `name` may become a value of the target's type. */
bool mayBecome(const std::string& name, const PropertyBase& target, std::string& why) {
    if (isPlainBagType(name) || name == "Sequence") return true;
    const types::TypeInfo* type = types::Types()->type(name);
    if (type && type == target.getTypeInfo()) return true;
    why = "property '" + target.getName() + "' of type " + target.getType() + " cannot take a value of type " + name;
    if (!type) why += ", which no typekit knows";
    return false;
}

/** A copy of the item; bags that name a type become a value of that type. Null, and a report, if that fails. */
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
    if (made && types::detail::updateByAnyMeans(made->getDataSource(), item.getDataSource())) return made;
    delete made;
    how.report(&item, "property '" + item.getName() + "' cannot be made: type " + bag->getType() +
                          (type ? " cannot be composed from these members" : " is not known to any typekit"));
    return nullptr;
}

bool addMissingItems(PropertyBag& target, const PropertyBag& source, const BagUpdate& how) {
    Pairing pairing;
    bool good = true;
    const std::size_t had = target.size();
    for (std::size_t i = 0; i != source.size(); ++i) {
        const PropertyBase* item = source.getItem(i);
        const bool known = item->getName().empty() ? i < had : pairing.next(target, item->getName()) != nullptr;
        if (!known) good = target.ownProperty(newItem(*item, how)) && good;
    }
    return good;
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

bool updateBag(PropertyBag& target, const PropertyBag& source, const BagUpdate& how) {
    const bool good = refreshItems(target, source, how);
    return (!how.addMissing || addMissingItems(target, source, how)) && good;
}

bool updateOne(PropertyBase& target, const PropertyBase& source, const BagUpdate& how) {
    if (how.fillDescriptions && target.getDescription().empty()) target.setDescription(source.getDescription());
    PropertyBag* targetBag = bagOf(target);
    const PropertyBag* sourceBag = bagOf(source);
    if (targetBag && sourceBag) {
        if (!isPlainBagType(targetBag->getType()) && targetBag->getType() != sourceBag->getType()) {
            how.report(&source, "property bag '" + target.getName() + "' of type " + targetBag->getType() +
                                    " cannot be filled from one of type " + sourceBag->getType());
            return false;
        }
        const bool good = updateBag(*targetBag, *sourceBag, how);
        target.getDataSource()->updated();
        return good;
    }
    std::string why;
    if (sourceBag && !mayBecome(sourceBag->getType(), target, why)) {
        how.report(&source, why);
        return false;
    }
    if (types::detail::updateByAnyMeans(target.getDataSource(), source.getDataSource())) return true;
    how.report(&source, "property '" + target.getName() + "' of type " + target.getType() +
                            (sourceBag ? " cannot be filled from the members given"
                                       : " cannot take a value of type " + source.getType()));
    return false;
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT
