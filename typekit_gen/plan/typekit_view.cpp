// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/typekit_view.hpp>

#include <algorithm>
#include <set>

#include <emit/banner.hpp>
#include <plan/access_view.hpp>
#include <plan/cpp_words.hpp>
#include <plan/library_view.hpp>
#include <plan/sources.hpp>
#include <plan/typekit_files.hpp>
#include <plan/schema_view.hpp>
#include <plan/type_needs.hpp>

namespace oroforge::typekit {

namespace {

using model::TypeKind;
using model::TypeUse;
using nlohmann::json;

std::string docOf(const model::Field& field) {
    if (field.capacity.empty()) return field.doc;
    return field.doc + (field.doc.empty() ? "" : ", ") + "at most " + field.capacity;
}

json viewOf(const model::Field& field, const model::Struct& of) {
    const bool isMeasured = of.proof.condition.empty();
    const std::string offset =
        isMeasured ? std::to_string(field.offset) : "__builtin_offsetof(" + of.cpp + ", " + field.name + ")";
    json view = {{"name", cppString(field.name)},  {"offset", offset},
                 {"type", field.type.cpp},         {"count", field.count},
                 {"doc", cppString(docOf(field))}, {"unit", cppString(field.unit)}};
    // A base class that is shown as a member has no name to check; its own struct is checked.
    const bool named = !field.declared.empty();
    if (!field.access.isPlace())
        view["access"] = accessView(field.access);
    else if (named)
        view["checked"] = {{"member", field.name}, {"declared", field.declared}};
    return view;
}

/// Arguments that few members have: access, range, another name.
std::string moreOf(const model::Field& field, std::size_t index) {
    const std::string access = field.access.isPlace() ? "nullptr" : "&access_" + std::to_string(index);
    const std::string also = field.also.empty() ? "" : ", " + cppString(field.also);
    if (!field.range.empty() || !also.empty()) return ", nullptr, " + access + ", " + cppString(field.range) + also;
    return field.access.isPlace() ? "" : ", nullptr, " + access;
}

json viewOf(const model::Struct& type) {
    json view = {{"cpp", type.cpp},   {"shown", cppShown(type.cpp)}, {"name", cppString(type.name)},
                 {"size", type.size}, {"align", type.align},         {"doc", cppString(type.doc)}};
    if (!type.proof.condition.empty())
        view["proof"] = {{"condition", type.proof.condition}, {"otherwise", cppString(type.proof.otherwise)}};
    if (!type.fields.empty()) view["hasFields"] = true;
    view["fieldCount"] = type.fields.size();
    view["fields"] = json::array();
    for (const model::Field& field : type.fields) {
        view["fields"].push_back(viewOf(field, type));
        json& added = view["fields"].back();
        added["index"] = view["fields"].size() - 1;
        added["more"] = moreOf(field, view["fields"].size() - 1);
    }
    return view;
}

json viewOf(const model::Adapted& type) {
    json view = {{"cpp", type.cpp},     {"shown", cppShown(type.cpp)}, {"name", cppString(type.name)},
                 {"size", type.size},   {"align", type.align},         {"doc", cppString(type.doc)},
                 {"count", type.count}, {"element", type.element.cpp}};
    view.update(accessView(type.access));
    view[type.columns.empty() ? "isSequence" : "isMatrix"] = true;
    if (!type.columns.empty()) view["columns"] = {{"text", type.columns}, {"row", type.row.cpp}};
    const auto isNumber = [](const std::string& text) {
        return text.find_first_not_of("0123456789") == std::string::npos;
    };
    if (isNumber(type.count)) view["fixedCount"] = true;
    if (isNumber(type.columns)) view["fixedColumns"] = true;
    if (!type.resize.empty()) view["resize"] = {{"call", type.resize}};
    return view;
}

json viewOf(const model::Enum& type) {
    json view = {{"cpp", type.cpp},
                 {"shown", cppShown(type.cpp)},
                 {"name", cppString(type.name)},
                 {"size", type.size},
                 {"doc", cppString(type.doc)}};
    if (!type.values.empty()) view["hasValues"] = true;
    view["valueCount"] = type.values.size();
    view["values"] = json::array();
    for (const model::Enumerator& value : type.values) {
        view["values"].push_back({{"name", cppString(value.name)}, {"cpp", value.cpp}, {"doc", cppString(value.doc)}});
    }
    return view;
}

/// How a value is made without a default constructor. The user's words are looked up in the type's namespace.
template <class Type>
json makerView(const Type& type, const std::string& make, const std::string& space) {
    const std::size_t arguments = std::min(type.cpp.find('<'), type.cpp.size());
    const std::size_t colons = type.cpp.rfind("::", arguments);
    json view = {{"of", type.name}, {"cpp", type.cpp}, {"make", make}, {"key", cppIdentifier(type.cpp)}};
    view["own"] = type.cpp.substr(colons + 2, arguments - colons - 2);
    if (!space.empty()) view["space"] = space;
    return view;
}

/// The contents of the sources, by the number of the source.
struct Contents {
    const Placement& placement;
    std::vector<json> views;
    std::vector<std::vector<std::string>> types;
    json externs = json::array();
    json makers = json::array();
    std::set<std::pair<std::size_t, std::string>> headers;
    std::set<std::string> entries;

    explicit Contents(const Placement& where) : placement(where), types(where.sources().size()) {
        for (const Source& source : where.sources()) {
            json view = {{"word", source.word}};
            for (const char* list :
                 {"structs", "enums", "adapted", "aliases", "constructors", "library", "arrays", "instances", "system"})
                view[list] = json::array();
            views.push_back(std::move(view));
        }
    }
    void addHeader(const std::string& typeName, const std::string& header) {
        const std::size_t source = placement.of(typeName);
        if (!header.empty() && headers.insert({source, header}).second)
            views[source]["system"].push_back({{"path", header}});
    }
    void add(const char* list, const std::string& typeName, const json& view) {
        const std::size_t source = placement.of(typeName);
        views[source][list].push_back(view);
        types[source].push_back(typeName);
    }
    template <class Type>
    void addFromAdapter(const Type& type) {
        if (!type.initial.empty()) makers.push_back(makerView(type, type.initial, ""));
        for (const model::Constructor& one : type.constructors) {
            add("constructors", type.name,
                {{"name", cppString(type.name)},
                 {"cpp", type.cpp},
                 {"parameters", one.parameters},
                 {"value", one.value}});
            addHeader(type.name, "rtt/types/TemplateConstructor.hpp");
        }
    }
    void addInstance(const std::string& typeName, const std::string& cpp, bool isSample = true) {
        json view = {{"of", typeName}, {"cpp", cpp}};
        view[isSample ? "isSample" : "isValue"] = true;
        add("instances", typeName, view);
        externs.push_back(view);
    }
};

Contents fill(const model::TypeModel& model, const Placement& placement) {
    Contents contents(placement);
    for (const model::Struct& type : model.structs) {
        contents.add("structs", type.name, viewOf(type));
        for (const model::Field& field : type.fields)
            if (field.access.hasAddress) contents.addHeader(type.name, "rtt/types/AdaptedTable.hpp");
        if (type.instances) contents.addInstance(type.name, type.cpp, type.assignable && type.make.empty());
        if (!type.make.empty()) contents.makers.push_back(makerView(type, type.make, type.space));
        contents.addFromAdapter(type);
    }
    for (const model::Enum& type : model.enums) {
        contents.add("enums", type.name, viewOf(type));
        contents.addInstance(type.name, type.cpp);
    }
    for (const model::Adapted& type : model.adapted) {
        json view = viewOf(type);
        const std::size_t source = placement.of(type.name);
        view["access"] = "Access_" + placement.sources()[source].word + "_" +
                         std::to_string(contents.views[source]["adapted"].size());
        contents.add("adapted", type.name, view);
        contents.addHeader(type.name, "rtt/types/AdaptedTable.hpp");
        contents.addInstance(type.name, type.cpp);
        contents.addFromAdapter(type);
    }
    for (const model::Alias& alias : model.aliases)
        contents.add("aliases", alias.of, {{"name", cppString(alias.name)}, {"of", cppString(alias.of)}});
    // Ports and properties of a container are rare unless the user named it with an alias.
    std::set<std::string> named;
    for (const model::Alias& alias : model.aliases) named.insert(alias.of);
    for (const TypeUse& use : model.library) {
        if (isOfUserType(use) && named.count(use.name)) contents.addInstance(use.name, use.cpp);
        contents.add("library", use.name, libraryView(use));
        contents.addHeader(use.name, libraryHeader(use.kind));
        if (use.kind == TypeKind::Map && contents.entries.insert(entryName(use)).second) {
            contents.add("library", entryName(use), entryView(use));
            contents.addHeader(entryName(use), "rtt/types/KeyValue.hpp");
        }
    }
    for (const TypeUse& use : model.arrays) {
        const std::string name = model::arrayName(use);
        contents.add("arrays", name, {{"cpp", use.cpp}, {"name", cppString(name)}});
    }
    for (json& view : contents.views) {
        const bool used =
            std::any_of(view.begin(), view.end(), [](const json& list) { return list.is_array() && !list.empty(); });
        if (used) view["used"] = true;
    }
    return contents;
}

using Names = std::set<std::string>;

/// Returns the views of these types only.
json ofTypes(const json& views, const Names& types) {
    json result = json::array();
    for (const json& view : views)
        if (types.count(view["of"].get<std::string>()) != 0) result.push_back(view);
    return result;
}

/// True if a std::optional is shown whose header the user need not include: for what a smart pointer points to.
bool showsOptional(const model::TypeModel& model, const Names& types) {
    for (const model::Struct& type : model.structs)
        for (const model::Field& field : type.fields)
            if (field.type.kind == TypeKind::Optional && !field.access.isPlace() && types.count(field.type.name) != 0)
                return true;
    return false;
}

/// Adds includes, and a first line that names the headers; it shows `otherwise` if there are none.
void addFront(json& view, const model::TypeModel& model, const Needs& needs, const std::string& otherwise,
              const std::string& tool) {
    std::string names;
    view["includes"] = json::array();
    for (const std::size_t header : needs.headers) {
        const std::string& include = model.headers[header].include;
        view["includes"].push_back({{"path", include}});
        for (const std::string& more : model.headers[header].more) view["includes"].push_back({{"path", more}});
        names += (names.empty() ? "" : ", ") + include;
    }
    if (showsOptional(model, needs.types)) view["system"].push_back({{"path", "optional"}});
    view["banner"] = emit::banner(tool, names.empty() ? otherwise : names);
}

Needs allOf(const model::TypeModel& model, const Contents& contents) {
    Needs needs;
    for (const auto& types : contents.types) needs.types.insert(types.begin(), types.end());
    for (std::size_t i = 0; i != model.headers.size(); ++i) needs.headers.push_back(i);
    return needs;
}

}  // namespace

json makeView(const model::TypeModel& model, const std::string& typekit, const std::string& tool) {
    const TypeNeeds typeNeeds(model);
    const Placement placement(model, typeNeeds);
    Contents contents = fill(model, placement);
    const json schemas = schemaViews(model);
    for (std::size_t i = 0; i != contents.views.size(); ++i) {
        const Needs needs = typeNeeds.of(contents.types[i]);
        json& view = contents.views[i];
        addFront(view, model, needs, model.headers[placement.sources()[i].header].include, tool);
        view["externs"] = ofTypes(contents.externs, needs.types);
        view["makers"] = ofTypes(contents.makers, needs.types);
        view["schemas"] = ofTypes(schemas, needs.types);
    }
    json view = {{"name", typekit},
                 {"quotedName", cppString(typekit)},
                 {"identifier", cppIdentifier(typekit)},
                 {"pluginBanner", emit::banner(tool, "the headers of " + typekit)},
                 {"versionGuard", emit::versionGuard(tool)},
                 {"userHeader", userHeaderName(typekit)},
                 {"system", json::array()},
                 {"externs", contents.externs},
                 {"makers", contents.makers},
                 {"schemas", schemas},
                 {"sources", contents.views}};
    addFront(view, model, allOf(model, contents), "the headers of " + typekit, tool);
    for (const model::Message& one : model.messages)
        view["messages"].push_back({{"type", cppString(one.type)},
                                    {"name", cppString(one.name)},
                                    {"md5", cppString(one.md5)},
                                    {"definition", cppLines(one.definition)}});
    if (!model.messages.empty()) view["hasMessages"] = true;
    return view;
}

}  // namespace oroforge::typekit
