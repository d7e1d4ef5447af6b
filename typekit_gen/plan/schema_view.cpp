// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/schema_view.hpp>

#include <cstdio>

#include <plan/cpp_words.hpp>
#include <plan/library_view.hpp>
#include <plan/stable_hash.hpp>

namespace oroforge::typekit {

namespace {

using model::TypeKind;
using model::TypeUse;
using nlohmann::json;

std::string keyOf(const std::string& cpp) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hashOf(cpp)));
    return digits;
}

json started(const std::string& type, const std::string& cpp) {
    return {
        {"of", type}, {"key", keyOf(cpp)}, {"cpp", cpp}, {"name", cppString(cppShown(cpp))}, {"fields", json::array()}};
}

void add(json& schema, json field) {
    schema["hasFields"] = true;
    schema["fields"].push_back(std::move(field));
    schema["count"] = schema["fields"].size();
}

json fieldView(const std::string& name, const std::string& type, const std::string& place, const TypeUse& use) {
    json view = {{"name", cppString(name)}, {"type", cppString(cppShown(type))}, {"place", place}};
    view["unit"] = "\"\"";
    view["of"] = isOfUserType(use) ? "&schemaOf<" + use.cpp + ">" : "nullptr";
    return view;
}

json viewOf(const model::Struct& type) {
    json view = started(type.name, type.cpp);
    for (const model::Field& field : type.fields) {
        // Where a field has a name, the plugin's compiler gives its offset.
        const bool named = field.access.isPlace() && !field.declared.empty();
        const std::string place =
            named ? "8LL * __builtin_offsetof(" + type.cpp + ", " + field.name + ")" : std::to_string(field.place);
        std::string declared = field.declared.empty() ? field.type.cpp : field.declared;
        if (field.width != 0) declared += " : " + std::to_string(field.width);
        json added = fieldView(field.name, declared, place, field.type);
        added["unit"] = cppString(field.unit);
        add(view, added);
    }
    return view;
}

json viewOf(const model::Enum& type) {
    json view = started(type.name, type.cpp);
    view["isEnum"] = true;
    for (const model::Enumerator& value : type.values)
        add(view, fieldView(value.name, "", "static_cast<long long>(" + value.cpp + ")", TypeUse()));
    return view;
}

json viewOfParts(const TypeUse& use) {
    json view = started(use.name, use.cpp);
    std::size_t index = 0;
    for (const TypeUse& element : use.element) {
        const std::string name =
            use.kind == TypeKind::Variant ? alternativeName(element) : "_" + std::to_string(index++);
        add(view, fieldView(name, element.cpp, "-1", element));
    }
    return view;
}

}  // namespace

bool isOfUserType(const TypeUse& use) {
    if (use.kind == TypeKind::Struct || use.kind == TypeKind::Enum) return true;
    for (const TypeUse& element : use.element)
        if (isOfUserType(element)) return true;
    return false;
}

json schemaViews(const model::TypeModel& model) {
    json views = json::array();
    for (const model::Struct& type : model.structs) views.push_back(viewOf(type));
    for (const model::Enum& type : model.enums) views.push_back(viewOf(type));
    for (const TypeUse& use : model.library)
        if ((use.kind == TypeKind::Tuple || use.kind == TypeKind::Variant) && isOfUserType(use))
            views.push_back(viewOfParts(use));
    return views;
}

}  // namespace oroforge::typekit
