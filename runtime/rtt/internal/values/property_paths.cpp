// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The functions of PropertyBag.hpp that work on paths and on whole bags.
#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include "property_update.hpp"

namespace RTT {

using base::PropertyBase;
using internal::detail::bagOf;
using internal::detail::BagUpdate;

namespace {

BagUpdate refreshing(bool needAll) {
    BagUpdate how;
    how.needAll = needAll;
    how.report = internal::detail::logUpdateError;
    return how;
}

BagUpdate updating() {
    BagUpdate how = refreshing(false);
    how.addMissing = true;
    how.fillDescriptions = true;
    return how;
}

/** Calls visit(path, property) for all properties, depth first. */
template <class Visit>
void visitAll(const PropertyBag& bag, const std::string& prefix, const std::string& separator, Visit visit) {
    for (const auto* property : bag) {
        const std::string path = prefix + property->getName();
        visit(path, *property);
        if (const PropertyBag* inner = bagOf(*property)) visitAll(*inner, path + separator, separator, visit);
    }
}

/** Separators at the beginning of a path have no meaning. */
std::string withoutSeparatorsInFront(std::string path, const std::string& separator) {
    while (!separator.empty() && path.compare(0, separator.size(), separator) == 0) path.erase(0, separator.size());
    return path;
}

std::string parentOf(const std::string& path, const std::string& separator) {
    auto at = path.rfind(separator);
    if (at == std::string::npos || separator.empty()) return std::string();
    // Consecutive separators count as one.
    while (at >= separator.size() && path.compare(at - separator.size(), separator.size(), separator) == 0)
        at -= separator.size();
    return path.substr(0, at);
}

}  // namespace

std::vector<std::string> listProperties(const PropertyBag& bag, const std::string& separator) {
    std::vector<std::string> paths;
    visitAll(bag, "", separator, [&](const std::string& path, const PropertyBase&) { paths.push_back(path); });
    return paths;
}

std::vector<std::string> listPropertyDescriptions(const PropertyBag& bag, const std::string& separator) {
    std::vector<std::string> texts;
    visitAll(bag, "", separator,
             [&](const std::string&, const PropertyBase& property) { texts.push_back(property.getDescription()); });
    return texts;
}

PropertyBase* findProperty(const PropertyBag& bag, const std::string& path, const std::string& separator) {
    if (PropertyBase* found = bag.find(path)) return found;
    const std::string name = withoutSeparatorsInFront(path, separator);
    if (name != path) return name.empty() ? nullptr : findProperty(bag, name, separator);
    for (auto at = path.find(separator); at != std::string::npos; at = path.find(separator, at + 1)) {
        const PropertyBase* outer = bag.find(path.substr(0, at));
        const PropertyBag* inner = outer ? bagOf(*outer) : nullptr;
        if (!inner) continue;
        if (PropertyBase* found = findProperty(*inner, path.substr(at + separator.size()), separator)) return found;
    }
    return nullptr;
}

bool storeProperty(PropertyBag& bag, const std::string& given, PropertyBase* item, const std::string& separator) {
    const std::string path = withoutSeparatorsInFront(given, separator);
    if (path.empty()) return bag.ownProperty(item);
    const auto at = path.find(separator);
    const std::string name = path.substr(0, at);
    if (!bag.find(name)) bag.ownProperty(new Property<PropertyBag>(name, ""));
    PropertyBag* inner = bagOf(*bag.find(name));
    if (!inner) return false;
    return storeProperty(*inner, at == std::string::npos ? "" : path.substr(at + separator.size()), item, separator);
}

bool removeProperty(PropertyBag& bag, const std::string& path, const std::string& separator) {
    PropertyBase* found = findProperty(bag, path, separator);
    if (!found) return false;
    if (bag.removeProperty(found)) return true;
    const PropertyBase* outer = findProperty(bag, parentOf(path, separator), separator);
    PropertyBag* inner = outer ? bagOf(*outer) : nullptr;
    return inner && inner->removeProperty(found);
}

bool refreshProperties(const PropertyBag& target, const PropertyBag& source, bool allprops) {
    // Only values change, not the bag.
    return internal::detail::updateBag(const_cast<PropertyBag&>(target), source, refreshing(allprops));
}

bool refreshProperty(const PropertyBag& target, const PropertyBase& source) {
    PropertyBase* found = target.find(source.getName());
    return found && internal::detail::updateOne(*found, source, refreshing(false));
}

bool refreshProperty(const PropertyBag& target, const PropertyBag& source, const std::string& path,
                     const std::string& separator) {
    const PropertyBase* from = findProperty(source, path, separator);
    PropertyBase* to = findProperty(target, path, separator);
    if (!from) log(Error) << "property '" << path << "' is not present in the source" << endlog();
    if (!to) log(Error) << "property '" << path << "' is not present in the target" << endlog();
    return from && to && internal::detail::updateOne(*to, *from, refreshing(false));
}

bool updateProperties(PropertyBag& target, const PropertyBag& source) {
    return internal::detail::updateBag(target, source, updating());
}

bool updateProperty(PropertyBag& target, const PropertyBag& source, const std::string& path,
                    const std::string& separator) {
    const PropertyBase* from = findProperty(source, path, separator);
    if (!from) {
        log(Error) << "property '" << path << "' is not present in the source" << endlog();
        return false;
    }
    if (PropertyBase* to = findProperty(target, path, separator))
        return internal::detail::updateOne(*to, *from, updating());
    return storeProperty(target, parentOf(path, separator), from->clone(), separator);
}

bool copyProperties(PropertyBag& target, const PropertyBag& source) {
    bool good = true;
    for (const auto* property : source) good = target.ownProperty(property->clone()) && good;
    return good;
}

void deleteProperties(PropertyBag& bag) {
    for (auto* property : PropertyBag::Properties(bag.getProperties())) {
        const bool owned = bag.ownsProperty(property);
        bag.removeProperty(property);
        if (!owned) delete property;
    }
}

void deletePropertyBag(PropertyBag& bag) {
    for (const auto* property : bag)
        if (PropertyBag* inner = bagOf(*property)) deletePropertyBag(*inner);
    deleteProperties(bag);
}

void flattenPropertyBag(PropertyBag& bag, const std::string& separator) {
    // New properties on the same data sources, so that references to the values stay valid.
    PropertyBag::Properties flat;
    for (auto* property : bag) {
        PropertyBag* inner = bagOf(*property);
        if (inner) flattenPropertyBag(*inner, separator);
        if (!inner || inner->empty()) {
            flat.push_back(property->create(property->getDataSource()));
            continue;
        }
        for (const auto* item : *inner) {
            flat.push_back(item->create(item->getDataSource()));
            flat.back()->setName(property->getName() + separator + item->getName());
        }
    }
    bag.clear();
    for (auto* property : flat) bag.ownProperty(property);
}

}  // namespace RTT
