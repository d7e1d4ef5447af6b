// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "property_file.hpp"

#include "cpf_writer.hpp"

#include <rtt/internal/detail/property_update.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

#include <filesystem>
#include <memory>

namespace RTT {
namespace marsh {

using base::PropertyBase;
using internal::detail::bagOf;
using internal::detail::BagUpdate;

namespace {

/** Copies all values, also those that the bags only refer to. */
void copyDeep(const PropertyBag& from, PropertyBag& to) {
    for (const auto* item : from) {
        const PropertyBag* inner = bagOf(*item);
        if (!inner) {
            to.ownProperty(item->clone());
            continue;
        }
        auto* made = new Property<PropertyBag>(item->getName(), item->getDescription());
        made->value().setType(inner->getType());
        to.ownProperty(made);
        copyDeep(*inner, made->value());
    }
}

/** Puts the values back and removes what was added, which stands behind what was there. */
void restore(PropertyBag& bag, const PropertyBag& saved) {
    while (bag.size() > saved.size()) bag.removeProperty(bag.getItem(bag.size() - 1));
    for (std::size_t i = 0; i != bag.size(); ++i) {
        const PropertyBase* from = saved.getItem(i);
        PropertyBag* inner = bagOf(*bag.getItem(i));
        const PropertyBag* savedInner = bagOf(*from);
        if (inner && savedInner)
            restore(*inner, *savedInner);
        else
            bag.getItem(i)->getDataSource()->update(from->getDataSource().get());
    }
}

BagUpdate reporting(const std::string& file, const Places& places, diag::Sink& sink) {
    BagUpdate how;
    how.report = [&file, &places, &sink](const PropertyBase* where, const std::string& text) {
        const auto at = places.find(where);
        sink.error(at == places.end() ? diag::Location{file, 0, 0} : at->second, "CPF020", text);
    };
    return how;
}

/** The file's items in their order, each replaced by that of `bag`; what is new behind them if `addNew`. */
void mergeInto(PropertyBag& file, const PropertyBag& bag, bool addNew) {
    PropertyBag merged(file.getType());
    for (const auto* item : file) {
        const PropertyBase* mine = bag.find(item->getName());
        const PropertyBag* theirBag = bagOf(*item);
        const PropertyBag* myBag = mine ? bagOf(*mine) : nullptr;
        if (!theirBag || !myBag || myBag->getType() != "PropertyBag") {
            merged.ownProperty((mine ? mine : item)->clone());
            continue;
        }
        auto* inner = new Property<PropertyBag>(item->getName(), mine->getDescription(), *theirBag);
        merged.ownProperty(inner);
        mergeInto(inner->value(), *myBag, addNew);
    }
    for (const auto* item : bag)
        if (addNew && !file.find(item->getName())) merged.ownProperty(item->clone());
    file = merged;
}

bool exists(const std::string& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
}

bool write(const std::string& file, const PropertyBag& bag, diag::Sink& sink) {
    if (writeFile(file, cpfText(bag))) return true;
    sink.error({file, 0, 0}, "CPF030", "cannot write the file");
    return false;
}

}  // namespace

bool loadFromFile(PropertyBag& bag, const std::string& file, LoadMode mode, diag::Sink& sink) {
    PropertyBag read, saved;
    Places places;
    if (!readFile(file, read, sink, &places)) return false;
    copyDeep(bag, saved);
    BagUpdate how = reporting(file, places, sink);
    how.needAll = mode == LoadMode::strictRefresh;
    how.addMissing = mode == LoadMode::load;
    how.fillDescriptions = how.addMissing;
    if (internal::detail::updateBag(bag, read, how)) return true;
    restore(bag, saved);
    return false;
}

bool loadOneFromFile(PropertyBag& bag, const std::string& file, const std::string& path, diag::Sink& sink) {
    PropertyBag read;
    Places places;
    if (!readFile(file, read, sink, &places)) return false;
    PropertyBase* to = findProperty(bag, path);
    const PropertyBase* from = findProperty(read, path);
    if (!from) sink.error({file, 0, 0}, "CPF021", "property '" + path + "' is not in the file");
    if (!to) sink.error({}, "CPF022", "there is no property '" + path + "' to read");
    if (!from || !to) return false;
    PropertyBag saved, both;
    both.add(to);
    copyDeep(both, saved);
    if (internal::detail::updateOne(*to, *from, reporting(file, places, sink))) return true;
    restore(both, saved);
    return false;
}

bool saveToFile(const PropertyBag& bag, const std::string& file, SaveMode mode, diag::Sink& sink) {
    PropertyBag simple;
    types::decomposePropertyBag(bag, simple);
    if (mode == SaveMode::store || !exists(file)) return write(file, simple, sink);
    PropertyBag read;
    if (!readFile(file, read, sink)) return false;
    mergeInto(read, simple, mode == SaveMode::merge);
    return write(file, read, sink);
}

bool saveOneToFile(const PropertyBag& bag, const std::string& file, const std::string& path, diag::Sink& sink) {
    const PropertyBase* one = findProperty(bag, path);
    if (!one) {
        sink.error({}, "CPF022", "there is no property '" + path + "' to write");
        return false;
    }
    PropertyBag only, simple, read;
    const auto dot = path.rfind('.');
    storeProperty(only, dot == std::string::npos ? "" : path.substr(0, dot), one->clone());
    types::decomposePropertyBag(only, simple);
    if (exists(file) && !readFile(file, read, sink)) return false;
    mergeInto(read, simple, true);
    return write(file, read, sink);
}

}  // namespace marsh
}  // namespace RTT
