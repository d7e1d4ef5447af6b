// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/typekit_view.hpp>

#include <array>
#include <cctype>

#include <emit/banner.hpp>
#include <plan/output_names.hpp>

namespace oroforge::typekit {

namespace {

using model::TypeKind;
using model::TypeUse;
using nlohmann::json;

std::string withoutColons(const std::string& cpp) { return cpp.compare(0, 2, "::") == 0 ? cpp.substr(2) : cpp; }

json viewOf(const model::Field& field, bool last) {
    json view = {{"name", field.name},          {"offset", field.offset},      {"type", field.type.cpp},
                 {"count", field.count},        {"doc", cppString(field.doc)}, {"unit", cppString(field.unit)},
                 {"separator", last ? "" : ","}};
    view[field.count == 0 ? "isSingle" : "isArray"] = true;
    return view;
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

/// Sequences of the user's own types are instantiated here; those of numbers and strings belong to the runtime.
bool isOfUserType(const TypeUse& use) {
    if (use.kind == TypeKind::Sequence) return isOfUserType(use.element.front());
    return use.kind == TypeKind::Struct || use.kind == TypeKind::Enum;
}

struct Buckets {
    std::array<json, kBuckets> all;
    json externs = json::array();

    Buckets() {
        for (std::size_t i = 0; i < kBuckets; ++i) {
            all[i] = {{"index", i},
                      {"structs", json::array()},
                      {"enums", json::array()},
                      {"sequences", json::array()},
                      {"arrays", json::array()},
                      {"instances", json::array()}};
        }
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
    for (const TypeUse& use : model.sequences) {
        buckets.add("sequences", use.name, {{"cpp", use.cpp}, {"name", cppString(use.name)}});
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

std::string cppString(const std::string& text) {
    static const char* const kDigits = "01234567";
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n') {
            result += "\\n";
        } else if (c == '"' || c == '\\') {
            result += std::string("\\") + c;
        } else if (byte < 0x20 || byte == 0x7f) {
            // Three octal digits end by themselves, whatever follows.
            result += std::string("\\") + kDigits[byte >> 6] + kDigits[(byte >> 3) & 7] + kDigits[byte & 7];
        } else {
            result += c;
        }
    }
    return result + "\"";
}

std::string cppIdentifier(const std::string& text) {
    std::string result;
    for (const char c : text) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    if (!result.empty() && std::isdigit(static_cast<unsigned char>(result[0])) != 0) result.insert(0, "_");
    return result;
}

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
