// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/bucket_needs.hpp>

#include <algorithm>

#include <plan/library_view.hpp>

namespace oroforge::typekit {

namespace {

using model::TypeKind;
using model::TypeUse;
using Headers = std::vector<std::size_t>;

Headers merged(const Headers& a, const Headers& b) {
    std::set<std::size_t> all(a.begin(), a.end());
    all.insert(b.begin(), b.end());
    return {all.begin(), all.end()};
}

const model::Homes kKnown = {{}};

bool isLeaf(const TypeUse& use) { return use.kind == TypeKind::Scalar || use.kind == TypeKind::String; }

/// The runtime's headers bring along what it takes.
bool isKnownAnyway(const TypeUse& use) {
    if (isLeaf(use)) return true;
    const bool isVector = use.kind == TypeKind::Sequence && use.element.size() == 1 &&
                          use.cpp == "std::vector<" + use.element[0].cpp + ">";
    return isVector && isKnownAnyway(use.element[0]);
}

bool isNamed(const TypeUse& use) { return use.kind == TypeKind::Struct || use.kind == TypeKind::Enum; }

void addWithThoseBefore(std::size_t header, const std::vector<model::Header>& headers, std::set<std::size_t>& to) {
    if (header >= headers.size() || !to.insert(header).second) return;
    for (const std::size_t before : headers[header].before) addWithThoseBefore(before, headers, to);
}

}  // namespace

BucketNeeds::BucketNeeds(const model::TypeModel& model) : model_(model) {
    for (const model::Struct& type : model.structs) {
        Node& node = nodes_[type.name] = {{}, type.homes, type.homes.empty()};
        for (const model::Field& field : type.fields) node.parts.push_back(&field.type);
        addArguments(type.constructors, type.homes, node);
    }
    for (const model::Enum& type : model.enums) nodes_[type.name] = {{}, type.homes, type.homes.empty()};
    for (const model::Adapted& type : model.adapted) {
        nodes_[type.name] = {{&type.element}, type.homes, type.homes.empty()};
        addUse(type.element, type.homes);
        addArguments(type.constructors, type.homes, nodes_[type.name]);
        if (type.columns.empty()) continue;
        nodes_[type.name].parts.push_back(&type.row);
        addUse(type.row, type.homes);
    }
    for (const model::Struct& type : model.structs) {
        for (const model::Field& field : type.fields) {
            addUse(field.type, type.homes);
            if (field.count != 0) addArray(field.type, type.homes);
        }
    }
}

void BucketNeeds::addArguments(const std::vector<model::Constructor>& all, const model::Homes& homes, Node& to) {
    for (const model::Constructor& one : all) {
        for (const TypeUse& argument : one.arguments) {
            to.parts.push_back(&argument);
            addUse(argument, homes);
        }
    }
}

void BucketNeeds::addArray(const TypeUse& use, const model::Homes& homes) {
    Node& node = nodes_[use.name + "[]"];
    node.parts = {&use};
    node.isUnknown |= homes.empty() && !isLeaf(use);
    if (node.homes.empty()) node.homes.resize(1);
    if (!homes.empty() && !isLeaf(use)) node.homes[0] = merged(node.homes[0], homes[0]);
}

/// What a struct has as a field is known where the struct is.
void BucketNeeds::addUse(const TypeUse& use, const model::Homes& homes) {
    if (isNamed(use) || isLeaf(use)) return;
    add(use.name, use.element, isKnownAnyway(use) ? kKnown : homes);
    if (use.kind == TypeKind::Map) add(entryName(use), use.element, homes);
    for (const TypeUse& element : use.element) addUse(element, homes);
}

void BucketNeeds::add(const std::string& name, const std::vector<TypeUse>& parts, const model::Homes& homes) {
    Node& node = nodes_[name];
    if (node.parts.empty())
        for (const TypeUse& part : parts) node.parts.push_back(&part);
    node.isUnknown |= homes.empty();
    if (node.homes.empty()) node.homes.resize(1);
    if (!homes.empty()) node.homes[0] = merged(node.homes[0], homes[0]);
}

void BucketNeeds::collect(const std::string& name, std::set<std::string>& to) const {
    const auto found = nodes_.find(name);
    if (found == nodes_.end() || !to.insert(name).second) return;
    for (const TypeUse* part : found->second.parts) collect(part->name, to);
}

Headers BucketNeeds::headersOf(const std::set<std::string>& names) const {
    std::set<Headers> open;
    for (const std::string& name : names) {
        const Node& node = nodes_.at(name);
        if (node.isUnknown) {
            Headers all(model_.headers.size());
            for (std::size_t i = 0; i != all.size(); ++i) all[i] = i;
            return all;
        }
        open.insert(node.homes.begin(), node.homes.end());
    }
    // Where there is a choice, what is there anyway comes first.
    std::set<std::size_t> chosen;
    for (const Headers& any : open)
        if (any.size() == 1) addWithThoseBefore(any[0], model_.headers, chosen);
    for (const Headers& any : open) {
        const auto isThere = [&](std::size_t header) { return chosen.count(header) != 0; };
        if (!any.empty() && std::none_of(any.begin(), any.end(), isThere))
            addWithThoseBefore(any[0], model_.headers, chosen);
    }
    return {chosen.begin(), chosen.end()};
}

Needs BucketNeeds::of(const std::vector<std::string>& names) const {
    Needs needs;
    for (const std::string& name : names) collect(name, needs.types);
    needs.headers = headersOf(needs.types);
    return needs;
}

}  // namespace oroforge::typekit
