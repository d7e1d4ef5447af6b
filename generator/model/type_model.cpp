// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "type_model.hpp"

#include <nlohmann/json.hpp>

namespace oroforge::model {

namespace {

using Json = nlohmann::ordered_json;

std::string place(const diag::Location& where) {
    return where.file.str() + ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
}

void addText(Json& json, const char* key, const std::string& text) {
    if (!text.empty()) json[key] = text;
}

const char* word(TypeKind kind) {
    switch (kind) {
        case TypeKind::Scalar: return "scalar";
        case TypeKind::String: return "string";
        case TypeKind::Enum: return "enum";
        case TypeKind::Struct: return "struct";
        case TypeKind::Sequence: return "sequence";
        case TypeKind::Linked: return "linked";
        case TypeKind::Set: return "set";
        case TypeKind::Map: return "map";
        case TypeKind::Optional: return "optional";
        case TypeKind::Variant: return "variant";
        case TypeKind::Pair: return "pair";
        case TypeKind::Tuple: return "tuple";
        case TypeKind::Complex: return "complex";
        case TypeKind::Character: return "character";
        case TypeKind::LongDouble: return "long double";
        case TypeKind::Nothing: return "nothing";
        case TypeKind::Count: return "count";
        case TypeKind::Bits: return "bits";
    }
    return "";
}

Json toJson(const TypeUse& use) {
    Json json = {{"kind", word(use.kind)}, {"cpp", use.cpp}, {"name", use.name}};
    if (use.element.size() == 1) json["element"] = toJson(use.element.front());
    if (use.element.size() > 1)
        for (const TypeUse& element : use.element) json["elements"].push_back(toJson(element));
    addText(json, "unit", use.unit);
    return json;
}

Json toJson(const FieldAccess& access) {
    Json json = {{"by", word(access.kind)}};
    addText(json, "get", access.get);
    addText(json, "set", access.set);
    if (access.number != 0) json["number"] = access.number;
    addText(json, "pointee", access.pointee);
    if (access.isAssigned) json["assigned"] = true;
    if (access.hasAddress) json["address"] = true;
    return json;
}

Json toJson(const Field& field) {
    Json json = {{"name", field.name}, {"type", toJson(field.type)}};
    if (field.declared != field.type.cpp) json["declared"] = field.declared;
    if (field.access.isPlace())
        json["offset"] = field.offset;
    else
        json["bit"] = field.place;
    if (field.width != 0) json["width"] = field.width;
    if (field.count != 0) json["count"] = field.count;
    if (!field.access.isPlace()) json["access"] = toJson(field.access);
    addText(json, "doc", field.doc);
    addText(json, "unit", field.unit);
    addText(json, "range", field.range);
    addText(json, "capacity", field.capacity);
    addText(json, "initial", field.initial);
    addText(json, "also", field.also);
    addText(json, "base", field.base);
    json["where"] = place(field.where);
    return json;
}

Json toJson(const Struct& type) {
    Json json = {{"cpp", type.cpp}, {"name", type.name}, {"size", type.size}, {"align", type.align}};
    if (!type.assignable) json["assignable"] = false;
    addText(json, "make", type.make);
    addText(json, "doc", type.doc);
    addText(json, "message", type.message);
    json["where"] = place(type.where);
    json["fields"] = Json::array();
    for (const Field& field : type.fields) json["fields"].push_back(toJson(field));
    return json;
}

Json toJson(const Enumerator& value) {
    Json json = {{"name", value.name}, {"cpp", value.cpp}, {"value", value.value}};
    addText(json, "doc", value.doc);
    return json;
}

Json toJson(const Enum& type) {
    Json json = {{"cpp", type.cpp}, {"name", type.name}, {"underlying", type.underlying}, {"size", type.size}};
    addText(json, "doc", type.doc);
    json["where"] = place(type.where);
    json["values"] = Json::array();
    for (const Enumerator& value : type.values) json["values"].push_back(toJson(value));
    return json;
}

Json toJson(const Adapted& type) {
    Json json = {{"cpp", type.cpp}, {"name", type.name}, {"size", type.size}, {"align", type.align}};
    addText(json, "doc", type.doc);
    json["where"] = place(type.where);
    json["element"] = toJson(type.element);
    if (!type.columns.empty()) json["row"] = toJson(type.row);
    addText(json, "count", type.count);
    addText(json, "columns", type.columns);
    addText(json, "resize", type.resize);
    json["access"] = toJson(type.access);
    return json;
}

Json toJson(const Alias& alias) { return {{"name", alias.name}, {"of", alias.of}, {"where", place(alias.where)}}; }

Json toJson(const Header& header) { return {{"path", header.path}, {"include", header.include}}; }

template <class T>
Json listOf(const std::vector<T>& all) {
    Json json = Json::array();
    for (const T& one : all) json.push_back(toJson(one));
    return json;
}

}  // namespace

std::string dump(const TypeModel& model) {
    Json json = {{"headers", listOf(model.headers)},
                 {"structs", listOf(model.structs)},
                 {"enums", listOf(model.enums)},
                 {"library", listOf(model.library)},
                 {"arrays", listOf(model.arrays)}};
    if (!model.adapted.empty()) json["adapted"] = listOf(model.adapted);
    if (!model.aliases.empty()) json["aliases"] = listOf(model.aliases);
    // Comments may contain bytes that are not UTF-8; these must not stop a dump.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace oroforge::model
