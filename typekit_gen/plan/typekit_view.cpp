// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/typekit_view.hpp>

#include <algorithm>
#include <algorithm>
#include <array>
#include <set>

#include <emit/banner.hpp>
#include <plan/cpp_words.hpp>
#include <plan/library_view.hpp>
#include <plan/output_names.hpp>
#include <plan/schema_view.hpp>

namespace oroforge::typekit {

namespace {

using model::TypeKind;
using model::TypeUse;
using nlohmann::json;

std::string docOf(const model::Field& field) {
    if (field.capacity.empty()) return field.doc;
    return field.doc + (field.doc.empty() ? "" : ", ") + "at most " + field.capacity;
}

json viewOf(const model::Field& field, bool last) {
    json view = {{"name", cppString(field.name)},  {"offset", std::to_string(field.offset)},
                 {"type", field.type.cpp},         {"count", field.count},
                 {"doc", cppString(docOf(field))}, {"unit", cppString(field.unit)},
                 {"separator", last ? "" : ","}};
    // A base class that is a member has no name that could be asked for; its own struct is checked.
    const bool named = !field.declared.empty();
    if (!field.address.empty()) view["address"] = field.address;
    if (!field.load.empty()) {
        view["load"] = field.load;
        if (!field.store.empty()) view["store"] = field.store;
    } else if (named) {
        view["checked"] = {{"member", field.name}, {"declared", field.declared}};
    }
    return view;
}

/// What few members have: a way to copy them, a range, another name.
std::string moreOf(const model::Field& field, std::size_t index) {
    const std::string access = field.load.empty() ? "nullptr" : "&access_" + std::to_string(index);
    const std::string also = field.also.empty() ? "" : ", " + cppString(field.also);
    if (!field.range.empty() || !also.empty()) return ", nullptr, " + access + ", " + cppString(field.range) + also;
    return field.load.empty() ? "" : ", nullptr, " + access;
}

json viewOf(const model::Struct& type) {
    json view = {{"cpp", type.cpp},   {"shown", cppShown(type.cpp)}, {"name", cppString(type.name)},
                 {"size", type.size}, {"align", type.align},         {"doc", cppString(type.doc)}};
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

json viewOf(const model::Adapted& type) {
    json view = {{"cpp", type.cpp},    {"shown", cppShown(type.cpp)}, {"name", cppString(type.name)},
                 {"size", type.size},  {"align", type.align},         {"doc", cppString(type.doc)},
                 {"load", type.load},  {"element", type.element.cpp}, {"store", type.store},
                 {"count", type.count}};
    view[type.columns.empty() ? "isSequence" : "isMatrix"] = true;
    if (!type.columns.empty()) view["columns"] = {{"text", type.columns}, {"row", type.row.cpp}};
    const auto isNumber = [](const std::string& text) {
        return text.find_first_not_of("0123456789") == std::string::npos;
    };
    if (isNumber(type.count)) view["fixedCount"] = true;
    if (isNumber(type.columns)) view["fixedColumns"] = true;
    if (!type.resize.empty()) view["resize"] = {{"call", type.resize}};
    if (!type.address.empty()) view["address"] = type.address;
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
        view["values"].push_back({{"name", cppString(value.name)},
                                  {"cpp", value.cpp},
                                  {"doc", cppString(value.doc)},
                                  {"separator", &value == &type.values.back() ? "" : ","}});
    }
    return view;
}

/// How a value is made where there is no default constructor. The user's words mean what they mean in the type's namespace.
json makerView(const model::Struct& type) {
    const std::size_t arguments = std::min(type.cpp.find('<'), type.cpp.size());
    const std::size_t colons = type.cpp.rfind("::", arguments);
    json view = {{"cpp", type.cpp}, {"make", type.make}, {"key", cppIdentifier(type.cpp)}};
    view["own"] = type.cpp.substr(colons + 2, arguments - colons - 2);
    if (!type.space.empty()) view["space"] = type.space;
    return view;
}

struct Buckets {
    std::array<json, kBuckets> all;
    json externs = json::array();
    json makers = json::array();
    std::set<std::string> headers;
    std::set<std::string> entries;

    Buckets() {
        for (std::size_t i = 0; i < kBuckets; ++i) {
            all[i] = {{"index", i},
                      {"structs", json::array()},
                      {"enums", json::array()},
                      {"adapted", json::array()},
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
    void addInstance(const std::string& typeName, const std::string& cpp, bool isSample = true) {
        json view = {{"cpp", cpp}};
        if (isSample) view["isSample"] = true;
        add("instances", typeName, view);
        externs.push_back(view);
    }
};

Buckets fillBuckets(const model::TypeModel& model) {
    Buckets buckets;
    for (const model::Struct& type : model.structs) {
        buckets.add("structs", type.name, viewOf(type));
        for (const model::Field& field : type.fields)
            if (!field.address.empty()) buckets.addHeader(type.name, "rtt/types/AdaptedTable.hpp");
        buckets.addInstance(type.name, type.cpp, type.assignable && type.make.empty());
        if (!type.make.empty()) buckets.makers.push_back(makerView(type));
    }
    for (const model::Enum& type : model.enums) {
        buckets.add("enums", type.name, viewOf(type));
        buckets.addInstance(type.name, type.cpp);
    }
    for (const model::Adapted& type : model.adapted) {
        json view = viewOf(type);
        const std::size_t bucket = bucketOf(type.name);
        view["access"] =
            "Access" + std::to_string(bucket) + "_" + std::to_string(buckets.all[bucket]["adapted"].size());
        buckets.add("adapted", type.name, view);
        buckets.addHeader(type.name, "rtt/types/AdaptedTable.hpp");
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
    for (json& bucket : buckets.all) {
        const bool used = std::any_of(bucket.begin(), bucket.end(),
                                      [](const json& list) { return list.is_array() && !list.empty(); });
        if (used) bucket["used"] = true;
    }
    return buckets;
}

/// A std::optional that the user's header need not know of: what a smart pointer points to.
bool showsOptional(const model::TypeModel& model) {
    for (const model::Struct& type : model.structs)
        for (const model::Field& field : type.fields)
            if (field.type.kind == TypeKind::Optional && !field.load.empty()) return true;
    return false;
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
                 {"makers", buckets.makers},
                 {"schemas", schemaViews(model)},
                 {"buckets", buckets.all}};
    view["includes"] = json::array();
    for (const model::Header& header : model.headers) view["includes"].push_back({{"path", header.include}});
    if (showsOptional(model)) view["includes"].push_back({{"path", "optional"}});
    return view;
}

}  // namespace oroforge::typekit
