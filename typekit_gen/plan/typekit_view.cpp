// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/typekit_view.hpp>

#include <array>
#include <set>

#include <emit/banner.hpp>
#include <plan/cpp_words.hpp>
#include <plan/library_view.hpp>
#include <plan/output_names.hpp>

namespace oroforge::typekit {

namespace {

using model::TypeKind;
using model::TypeUse;
using nlohmann::json;

std::string withoutColons(const std::string& cpp) { return cpp.compare(0, 2, "::") == 0 ? cpp.substr(2) : cpp; }

json viewOf(const model::Field& field, bool last) {
    json view = {{"name", cppString(field.name)}, {"offset", std::to_string(field.offset)},
                 {"type", field.type.cpp},        {"count", field.count},
                 {"doc", cppString(field.doc)},   {"unit", cppString(field.unit)},
                 {"separator", last ? "" : ","}};
    // A base class that is a member has no name that could be asked for; its own struct is checked.
    const bool named = !field.declared.empty();
    if (!field.load.empty()) {
        view["load"] = field.load;
        if (!field.store.empty()) view["store"] = field.store;
    } else if (named) {
        view["checked"] = {{"member", field.name}, {"declared", field.declared}};
    }
    return view;
}

/// What few members have: a way to copy them, a range.
std::string moreOf(const model::Field& field, std::size_t index) {
    const std::string access = field.load.empty() ? "nullptr" : "&access_" + std::to_string(index);
    if (!field.range.empty()) return ", nullptr, " + access + ", " + cppString(field.range);
    return field.load.empty() ? "" : ", nullptr, " + access;
}

json viewOf(const model::Struct& type) {
    json view = {
        {"cpp", type.cpp},     {"shown", withoutColons(type.cpp)}, {"name", cppString(type.name)}, {"size", type.size},
        {"align", type.align}, {"doc", cppString(type.doc)}};
    if (!type.fields.empty()) view["hasFields"] = true;
    view["fieldCount"] = type.fields.size();
    view["fields"] = json::array();
    for (const model::Field& field : type.fields) {
        view["fields"].push_back(viewOf(field, &field == &type.fields.back()));
        json& added = view["fields"].back();
        added["index"] = view["fields"].size() - 1;
        added["more"] = moreOf(field, view["fields"].size() - 1);
    }
    return view;
}

json viewOf(const model::Enum& type) {
    json view = {{"cpp", type.cpp},
                 {"shown", withoutColons(type.cpp)},
                 {"name", cppString(type.name)},
                 {"size", type.size},
                 {"doc", cppString(type.doc)}};
    if (!type.values.empty()) view["hasValues"] = true;
    view["valueCount"] = type.values.size();
    view["values"] = json::array();
    for (const model::Enumerator& value : type.values) {
        view["values"].push_back({{"name", cppString(value.name)},
                                  {"cpp", value.cpp},
                                  {"doc", cppString(value.doc)},
                                  {"separator", &value == &type.values.back() ? "" : ","}});
    }
    return view;
}

/// Types made of the user's own types are instantiated here; those of numbers and strings belong to the runtime.
bool isOfUserType(const TypeUse& use) {
    if (use.kind == TypeKind::Struct || use.kind == TypeKind::Enum) return true;
    for (const TypeUse& element : use.element)
        if (isOfUserType(element)) return true;
    return false;
}

struct Buckets {
    std::array<json, kBuckets> all;
    json externs = json::array();
    std::set<std::string> headers;
    std::set<std::string> entries;

    Buckets() {
        for (std::size_t i = 0; i < kBuckets; ++i) {
            all[i] = {{"index", i},
                      {"structs", json::array()},
                      {"enums", json::array()},
                      {"aliases", json::array()},
                      {"library", json::array()},
                      {"arrays", json::array()},
                      {"instances", json::array()}};
        }
    }
    void addHeader(const std::string& typeName, const std::string& header) {
        json& bucket = all[bucketOf(typeName)];
        if (header.empty() || !headers.insert(std::to_string(bucketOf(typeName)) + header).second) return;
        bucket["headers"].push_back({{"path", header}});
    }
    void add(const char* list, const std::string& typeName, const json& view) {
        all[bucketOf(typeName)][list].push_back(view);
    }
    void addInstance(const std::string& typeName, const std::string& cpp) {
        add("instances", typeName, {{"cpp", cpp}});
        externs.push_back({{"cpp", cpp}});
    }
};

Buckets fillBuckets(const model::TypeModel& model) {
    Buckets buckets;
    for (const model::Struct& type : model.structs) {
        buckets.add("structs", type.name, viewOf(type));
        buckets.addInstance(type.name, type.cpp);
    }
    for (const model::Enum& type : model.enums) {
        buckets.add("enums", type.name, viewOf(type));
        buckets.addInstance(type.name, type.cpp);
    }
    for (const model::Alias& alias : model.aliases)
        buckets.add("aliases", alias.of, {{"name", cppString(alias.name)}, {"of", cppString(alias.of)}});
    for (const TypeUse& use : model.library) {
        buckets.add("library", use.name, libraryView(use));
        buckets.addHeader(use.name, libraryHeader(use.kind));
        if (use.kind == TypeKind::Map && buckets.entries.insert(entryName(use)).second) {
            buckets.add("library", entryName(use), entryView(use));
            buckets.addHeader(entryName(use), "rtt/types/KeyValue.hpp");
        }
        if (isOfUserType(use)) buckets.addInstance(use.name, use.cpp);
    }
    for (const TypeUse& use : model.arrays) {
        const std::string name = use.name + "[]";
        buckets.add("arrays", name, {{"cpp", use.cpp}, {"name", cppString(name)}});
    }
    return buckets;
}

std::string sourceNames(const model::TypeModel& model) {
    std::string names;
    for (const model::Header& header : model.headers) names += (names.empty() ? "" : ", ") + header.include;
    return names;
}

}  // namespace

json makeView(const model::TypeModel& model, const std::string& typekit) {
    Buckets buckets = fillBuckets(model);
    json view = {{"name", typekit},
                 {"quotedName", cppString(typekit)},
                 {"identifier", cppIdentifier(typekit)},
                 {"banner", emit::banner("typegen", sourceNames(model))},
                 {"versionGuard", emit::versionGuard("typegen")},
                 {"userHeader", userHeaderName(typekit)},
                 {"externs", buckets.externs},
                 {"buckets", buckets.all}};
    view["includes"] = json::array();
    for (const model::Header& header : model.headers) view["includes"].push_back({{"path", header.include}});
    return view;
}

}  // namespace oroforge::typekit
