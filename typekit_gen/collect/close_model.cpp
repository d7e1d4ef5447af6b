// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <collect/close_model.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include <model/shown_name.hpp>

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

void addArguments(const std::vector<model::Constructor>& all, ByName& library) {
    for (const model::Constructor& one : all)
        for (const model::TypeUse& argument : one.arguments) addLibrary(argument, library);
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

/// Rejects shared names: ports and property files know a type only by its name, and would mix up the two.
class NameCheck {
public:
    explicit NameCheck(diag::Sink& sink) : sink_(sink) {}
    void add(const std::string& name, const std::string& cpp, const diag::Location& where) {
        const auto [first, isNew] = seen_.emplace(name, std::make_pair(cpp, where));
        if (isNew || first->second.first == cpp) return;
        sink_.error(where, "TK060", "type name '" + name + "' of '" + cpp + "' is already used")
            .note(first->second.second,
                  (first->second.second.line == 0 ? "it is the name of '" : "first used here for '") +
                      first->second.first + "'");
    }

private:
    diag::Sink& sink_;
    std::map<std::string, std::pair<std::string, diag::Location>> seen_;
};

bool isPartOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Replaces whole names only: "/demo/Point" is not replaced within "/demo/Pointer".
void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    std::size_t at = text.find(from);
    while (at != std::string::npos) {
        const std::size_t end = at + from.size();
        const bool isWhole =
            (at == 0 || !isPartOfName(text[at - 1])) && (end == text.size() || !isPartOfName(text[end]));
        if (isWhole) text.replace(at, from.size(), to);
        at = text.find(from, isWhole ? at + to.size() : at + 1);
    }
}

void rename(model::TypeUse& use, const std::string& from, const std::string& to) {
    replaceAll(use.name, from, to);
    for (model::TypeUse& element : use.element) rename(element, from, to);
}

void renameArguments(std::vector<model::Constructor>& all, const std::string& from, const std::string& to) {
    for (model::Constructor& one : all)
        for (model::TypeUse& argument : one.arguments) rename(argument, from, to);
}

/// A template instance takes the name of its first alias; the name made from its arguments becomes another alias.
void preferAliases(model::TypeModel& model) {
    std::map<std::string, std::string> preferred;  // instance → its first alias
    for (model::Alias& alias : model.aliases) {
        const auto [entry, isFirst] = preferred.emplace(alias.of, alias.name);
        if (isFirst)
            std::swap(alias.name, alias.of);
        else
            alias.of = entry->second;
    }
    // A type that keeps its name is now its own alias.
    model.aliases.erase(std::remove_if(model.aliases.begin(), model.aliases.end(),
                                       [](const model::Alias& alias) { return alias.name == alias.of; }),
                        model.aliases.end());
    // "/Q</P<3>>" goes before "/P<3>", or it would no longer be found.
    std::vector<std::pair<std::string, std::string>> ordered(preferred.begin(), preferred.end());
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
    for (const auto& [instance, name] : ordered) {
        for (model::Alias& alias : model.aliases) replaceAll(alias.of, instance, name);
        for (model::Struct& type : model.structs) {
            replaceAll(type.name, instance, name);
            for (model::Field& field : type.fields) rename(field.type, instance, name);
            renameArguments(type.constructors, instance, name);
        }
        for (model::Adapted& type : model.adapted) {
            replaceAll(type.name, instance, name);
            rename(type.element, instance, name);
            rename(type.row, instance, name);
            renameArguments(type.constructors, instance, name);
        }
    }
}

/// Whether a value of `use` may hold one of the struct `name`.
bool mayHold(const model::TypeUse& use, const std::string& name, const model::TypeModel& model,
             std::set<std::string>& seen) {
    if (use.name == name) return true;
    for (const model::TypeUse& element : use.element)
        if (mayHold(element, name, model, seen)) return true;
    if (use.kind != model::TypeKind::Struct || !seen.insert(use.name).second) return false;
    for (const model::Struct& type : model.structs) {
        if (type.name != use.name) continue;
        for (const model::Field& field : type.fields)
            if (mayHold(field.type, name, model, seen)) return true;
    }
    return false;
}

/// Rejects circles of pointers, which a file or a display would follow for ever; containers own what they hold.
void checkCircles(const model::TypeModel& model, diag::Sink& sink) {
    for (const model::Struct& type : model.structs) {
        for (const model::Field& field : type.fields) {
            std::set<std::string> seen;
            if (field.access.pointee.empty() || !mayHold(field.type, type.name, model, seen)) continue;
            sink.error(field.where, "TK035",
                       "field '" + field.name + "' of '" + model::cppShown(type.cpp) +
                           "' may point to what holds it: its value would have no end")
                .hint("use std::vector of the same type for children, or [[oro::skip]]");
        }
    }
}

}  // namespace

void closeModel(model::TypeModel& model, diag::Sink& sink) {
    preferAliases(model);
    ByName library, arrays;
    for (const model::Struct& type : model.structs) {
        addArguments(type.constructors, library);
        for (const model::Field& field : type.fields) {
            addLibrary(field.type, library);
            if (field.count != 0) arrays.emplace(field.type.name, field.type);
        }
    }
    for (const model::Adapted& type : model.adapted) {
        addLibrary(type.element, library);
        if (!type.columns.empty()) addLibrary(type.row, library);
        addArguments(type.constructors, library);
    }
    model.library = valuesOf(library);
    model.arrays = valuesOf(arrays);
    sortByName(model.structs);
    sortByName(model.enums);
    sortByName(model.adapted);
    std::sort(model.files.begin(), model.files.end());

    checkCircles(model, sink);
    NameCheck names(sink);
    for (const model::TypeUse& use : model.library) names.add(use.name, use.cpp, {});
    for (const model::Struct& type : model.structs) names.add(type.name, type.cpp, type.where);
    for (const model::Enum& type : model.enums) names.add(type.name, type.cpp, type.where);
    for (const model::Adapted& type : model.adapted) names.add(type.name, type.cpp, type.where);
    for (const model::Alias& alias : model.aliases) names.add(alias.name, "alias of " + alias.of, alias.where);
    if (model.structs.empty() && model.enums.empty() && model.adapted.empty()) {
        const std::string file = model.headers.empty() ? "typegen" : model.headers.front().path;
        sink.warning({file}, "TK061", "no struct, class or enum is defined in the listed headers: an empty typekit")
            .hint(
                "name the headers that define the types; a field, or 'template struct X<…>;', brings in those of "
                "others");
    }
}

}  // namespace oroforge::typekit
