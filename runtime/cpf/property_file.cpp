// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "property_file.hpp"

#include "cpf_edit.hpp"
#include "cpf_writer.hpp"
#include "replace_file.hpp"

#include <rtt/internal/values/property_update.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

#include <filesystem>
#include <memory>

namespace RTT::marsh {

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

/** Restores the saved values and removes the properties that were added after them. */
void restore(PropertyBag& bag, const PropertyBag& saved) {
    while (bag.size() > saved.size()) bag.removeProperty(bag.getItem(bag.size() - 1));
    for (std::size_t i = 0; i != bag.size(); ++i) {
        const PropertyBase* from = saved.getItem(i);
        bag.getItem(i)->setDescription(from->getDescription());
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

bool exists(const std::string& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
}

bool write(const std::string& file, const std::string& text, diag::Sink& sink) {
    const std::error_code failed = replaceFile(file, text);
    if (failed) sink.error({file, 0, 0}, "CPF030", "cannot write the file: " + failed.message());
    return !failed;
}

/** Updates an existing file with the values of `simple`. */
bool edit(const std::string& file, const PropertyBag& simple, bool addNew, diag::Sink& sink) {
    PropertyBag read;
    const auto text = xml::readText(file, sink);
    const auto document = text ? readText(*text, file, read, sink) : std::nullopt;
    return document && write(file, editedCpf(*text, document->root(), simple, addNew), sink);
}

}  // namespace

PropertyFile::PropertyFile(const std::string& file, diag::Sink& sink)
    : name(file), isGood(readFile(file, bag, sink, &places)) {}

bool loadFromFile(PropertyBag& bag, const std::string& file, LoadMode mode, diag::Sink& sink) {
    return loadFrom(PropertyFile(file, sink), bag, mode, sink);
}

bool loadFrom(const PropertyFile& file, PropertyBag& bag, LoadMode mode, diag::Sink& sink) {
    if (!file.isGood) return false;
    PropertyBag saved;
    copyDeep(bag, saved);
    BagUpdate how = reporting(file.name, file.places, sink);
    how.needAll = mode == LoadMode::strictRefresh;
    how.addMissing = mode == LoadMode::load;
    how.fillDescriptions = how.addMissing;
    if (internal::detail::updateBag(bag, file.bag, how)) return true;
    restore(bag, saved);
    return false;
}

bool loadOneFromFile(PropertyBag& bag, const std::string& file, const std::string& path, diag::Sink& sink) {
    const PropertyFile read(file, sink);
    if (!read.isGood) return false;
    PropertyBase* to = findProperty(bag, path);
    const PropertyBase* from = findProperty(read.bag, path);
    if (!from) sink.error({file, 0, 0}, "CPF021", "property '" + path + "' is not in the file");
    if (!to) sink.error({}, "CPF022", "there is no property '" + path + "' to read");
    if (!from || !to) return false;
    PropertyBag target, saved;
    target.add(to);
    copyDeep(target, saved);
    if (internal::detail::updateOne(*to, *from, reporting(file, read.places, sink))) return true;
    restore(target, saved);
    return false;
}

bool saveToFile(const PropertyBag& bag, const std::string& file, SaveMode mode, diag::Sink& sink) {
    PropertyBag simple;
    types::decomposePropertyBag(bag, simple);
    if (mode == SaveMode::store || !exists(file)) return write(file, cpfText(simple), sink);
    return edit(file, simple, mode == SaveMode::merge, sink);
}

bool saveOneToFile(const PropertyBag& bag, const std::string& file, const std::string& path, diag::Sink& sink) {
    const PropertyBase* one = findProperty(bag, path);
    if (!one) {
        sink.error({}, "CPF022", "there is no property '" + path + "' to write");
        return false;
    }
    PropertyBag only, simple;
    const auto dot = bag.find(path) ? std::string::npos : path.rfind('.');
    storeProperty(only, dot == std::string::npos ? "" : path.substr(0, dot), one->clone());
    types::decomposePropertyBag(only, simple);
    return exists(file) ? edit(file, simple, true, sink) : write(file, cpfText(simple), sink);
}

}  // namespace RTT::marsh
