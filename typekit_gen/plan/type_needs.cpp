// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/type_needs.hpp>

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

/// The runtime's headers declare everything that these types need.
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

/// Finds the header for a type whose parts come with these headers.
std::size_t homeFor(const model::Homes& homes) {
    if (homes.empty() || homes[0].empty()) return 0;
    for (const std::size_t header : homes[0]) {
        const auto has = [&](const Headers& any) { return std::find(any.begin(), any.end(), header) != any.end(); };
        if (std::all_of(homes.begin(), homes.end(), has)) return header;
    }
    return homes[0][0];
}

}  // namespace

template <class Type>
TypeNeeds::User TypeNeeds::addNamed(const Type& type) {
    const std::size_t home = homeFor(type.homes);
    nodes_[type.name] = {{}, type.homes, type.homes.empty(), home};
    return {type.homes, home};
}

TypeNeeds::TypeNeeds(const model::TypeModel& model) : model_(model) {
    for (const model::Enum& type : model.enums) addNamed(type);
    for (const model::Struct& type : model.structs) {
        const User user = addNamed(type);
        for (const model::Field& field : type.fields) {
            nodes_[type.name].parts.push_back(&field.type);
            addUse(field.type, user);
            if (field.count != 0) addArray(field.type, user);
        }
        addArguments(type.constructors, user, nodes_[type.name]);
    }
    for (const model::Adapted& type : model.adapted) {
        const User user = addNamed(type);
        for (const TypeUse* use : {&type.element, &type.row}) {
            if (use == &type.row && type.columns.empty()) continue;
            nodes_[type.name].parts.push_back(use);
            addUse(*use, user);
        }
        addArguments(type.constructors, user, nodes_[type.name]);
    }
    for (const TypeUse& use : model.library) {
        std::vector<const TypeUse*> parts;
        for (const TypeUse& element : use.element) parts.push_back(&element);
        addUnused(use.name, parts);
    }
    for (const TypeUse& use : model.arrays) addUnused(model::arrayName(use), {&use});
}

/// A library type that no field has belongs to the header of its first part.
void TypeNeeds::addUnused(const std::string& name, const std::vector<const TypeUse*>& parts) {
    if (nodes_.count(name) != 0) return;
    Node node;
    node.parts = parts;
    for (const TypeUse* part : parts) {
        const auto known = nodes_.find(part->name);
        if (known != nodes_.end()) node.home = std::min(node.home, known->second.home);
    }
    nodes_[name] = node;
}

void TypeNeeds::addArguments(const std::vector<model::Constructor>& all, const User& user, Node& to) {
    for (const model::Constructor& one : all) {
        for (const TypeUse& argument : one.arguments) {
            to.parts.push_back(&argument);
            addUse(argument, user);
        }
    }
}

void TypeNeeds::addArray(const TypeUse& use, const User& user) {
    Node& node = nodes_[model::arrayName(use)];
    node.parts = {&use};
    node.isUnknown |= user.homes.empty() && !isLeaf(use);
    node.home = std::min(node.home, user.home);
    if (node.homes.empty()) node.homes.resize(1);
    if (!user.homes.empty() && !isLeaf(use)) node.homes[0] = merged(node.homes[0], user.homes[0]);
}

/// The fields of a struct are known where the struct is.
void TypeNeeds::addUse(const TypeUse& use, const User& user) {
    if (isNamed(use) || isLeaf(use)) return;
    add(use.name, use.element, isKnownAnyway(use) ? User{kKnown, user.home} : user);
    if (use.kind == TypeKind::Map) add(entryName(use), use.element, user);
    for (const TypeUse& element : use.element) addUse(element, user);
}

void TypeNeeds::add(const std::string& name, const std::vector<TypeUse>& parts, const User& user) {
    Node& node = nodes_[name];
    if (node.parts.empty())
        for (const TypeUse& part : parts) node.parts.push_back(&part);
    node.isUnknown |= user.homes.empty();
    node.home = std::min(node.home, user.home);
    if (node.homes.empty()) node.homes.resize(1);
    if (!user.homes.empty()) node.homes[0] = merged(node.homes[0], user.homes[0]);
}

void TypeNeeds::collect(const std::string& name, std::set<std::string>& to) const {
    const auto found = nodes_.find(name);
    if (found == nodes_.end() || !to.insert(name).second) return;
    for (const TypeUse* part : found->second.parts) collect(part->name, to);
}

Headers TypeNeeds::headersOf(const std::set<std::string>& names) const {
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
    // Where there is a choice, headers that are included anyway come first.
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

Needs TypeNeeds::of(const std::vector<std::string>& names) const {
    Needs needs;
    for (const std::string& name : names) collect(name, needs.types);
    needs.headers = headersOf(needs.types);
    return needs;
}

std::size_t TypeNeeds::homeOf(const std::string& name) const {
    const auto found = nodes_.find(name);
    return found == nodes_.end() || found->second.home == kNowhere ? 0 : found->second.home;
}

}  // namespace oroforge::typekit
