// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <collect/close_model.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace oroforge::typekit {

namespace {

using ByName = std::map<std::string, model::TypeUse>;

bool isOfLibrary(model::TypeKind kind) {
    using model::TypeKind;
    return kind != TypeKind::Scalar && kind != TypeKind::String && kind != TypeKind::Enum && kind != TypeKind::Struct &&
           kind != TypeKind::Nothing;
}

void addLibrary(const model::TypeUse& use, ByName& library) {
    if (!isOfLibrary(use.kind)) return;
    library.emplace(use.name, use);
    for (const model::TypeUse& element : use.element) addLibrary(element, library);
}

std::vector<model::TypeUse> valuesOf(const ByName& all) {
    std::vector<model::TypeUse> result;
    for (const auto& [name, use] : all) result.push_back(use);
    return result;
}

template <class T>
void sortByName(std::vector<T>& all) {
    std::sort(all.begin(), all.end(), [](const T& a, const T& b) { return a.name < b.name; });
}

/// Ports and property files know types by these names, so a shared one would let wrong types meet.
class NameCheck {
public:
    explicit NameCheck(diag::Sink& sink) : sink_(sink) {}
    void add(const std::string& name, const std::string& cpp, const diag::Location& where) {
        const auto [first, isNew] = seen_.emplace(name, std::make_pair(cpp, where));
        if (isNew || first->second.first == cpp) return;
        sink_.error(where, "TK060", "type name '" + name + "' of '" + cpp + "' is already used")
            .note(first->second.second, "first used here for '" + first->second.first + "'");
    }

private:
    diag::Sink& sink_;
    std::map<std::string, std::pair<std::string, diag::Location>> seen_;
};

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

void rename(model::TypeUse& use, const std::string& from, const std::string& to) {
    replaceAll(use.name, from, to);
    for (model::TypeUse& element : use.element) rename(element, from, to);
}

/// A template instance is called by its first alias; the name made of its arguments becomes another alias of it.
void preferAliases(model::TypeModel& model) {
    std::map<std::string, std::string> preferred;  // instance → its first alias
    for (model::Alias& alias : model.aliases) {
        const auto [entry, isFirst] = preferred.emplace(alias.of, alias.name);
        if (isFirst)
            std::swap(alias.name, alias.of);
        else
            alias.of = entry->second;
    }
    for (const auto& [instance, name] : preferred) {
        for (model::Struct& type : model.structs) {
            replaceAll(type.name, instance, name);
            for (model::Field& field : type.fields) rename(field.type, instance, name);
        }
    }
}

}  // namespace

void closeModel(model::TypeModel& model, diag::Sink& sink) {
    preferAliases(model);
    ByName library, arrays;
    for (const model::Struct& type : model.structs) {
        for (const model::Field& field : type.fields) {
            addLibrary(field.type, library);
            if (field.count != 0) arrays.emplace(field.type.name, field.type);
        }
    }
    model.library = valuesOf(library);
    model.arrays = valuesOf(arrays);
    sortByName(model.structs);
    sortByName(model.enums);
    std::sort(model.files.begin(), model.files.end());

    NameCheck names(sink);
    for (const model::Struct& type : model.structs) names.add(type.name, type.cpp, type.where);
    for (const model::Enum& type : model.enums) names.add(type.name, type.cpp, type.where);
    for (const model::Alias& alias : model.aliases) names.add(alias.name, "alias of " + alias.of, alias.where);
    if (model.structs.empty() && model.enums.empty()) {
        const std::string file = model.headers.empty() ? "typegen" : model.headers.front().path;
        sink.warning({file}, "TK061", "no struct, class or enum is defined in the listed headers: an empty typekit");
    }
}

}  // namespace oroforge::typekit
