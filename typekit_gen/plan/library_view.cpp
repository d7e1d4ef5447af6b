// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/library_view.hpp>

#include <plan/access_view.hpp>
#include <plan/cpp_words.hpp>

namespace oroforge::typekit {

namespace {

using model::TypeKind;
using model::TypeUse;
using nlohmann::json;

json field(const std::string& name, const std::string& offset, const TypeUse& type) {
    return {{"name", cppString(name)}, {"offset", offset},      {"type", type.cpp}, {"count", 0},
            {"doc", cppString("")},    {"unit", cppString("")}, {"more", ""}};
}

std::string offsetOf(const std::string& cpp, const std::string& member) {
    return "__builtin_offsetof(" + cpp + ", " + member + ")";
}

json structView(const std::string& cpp, const std::string& name, json fields) {
    json view = {{"cpp", cpp}, {"name", cppString(name)}, {"fieldCount", fields.size()}};
    view["fields"] = std::move(fields);
    view["isStruct"] = true;
    return view;
}

json twoFields(const std::string& cpp, const std::string& name, const char* first, const TypeUse& firstType,
               const char* second, const TypeUse& secondType) {
    return structView(
        cpp, name, {field(first, offsetOf(cpp, first), firstType), field(second, offsetOf(cpp, second), secondType)});
}

/// Parts of a tuple have addresses, but no offsets that a constant could hold.
json tupleView(const TypeUse& use) {
    json fields = json::array();
    for (std::size_t i = 0; i != use.element.size(); ++i) {
        const std::string number = std::to_string(i);
        json view = field("_" + number, "0", use.element[i]);
        view["access"] = accessView({model::AccessKind::Part, number, number});
        view["index"] = i;
        view["more"] = ", nullptr, &access_" + number;
        fields.push_back(view);
    }
    return structView(use.cpp, use.name, fields);
}

std::string tableFor(const TypeUse& use) {
    switch (use.kind) {
        case TypeKind::Linked: return "RTT::types::linkedOps<" + use.cpp + ">()";
        case TypeKind::Set:
        case TypeKind::Map: return "RTT::types::keyedOps<" + use.cpp + ">()";
        case TypeKind::Optional: return "RTT::types::optionalOps<" + use.cpp + ">()";
        case TypeKind::Character: return "RTT::types::shownAsNumber<" + use.cpp + ">()";
        case TypeKind::LongDouble: return "RTT::types::shownAsText<" + use.cpp + ">()";
        case TypeKind::Count: return "RTT::types::shownAsCount<" + use.cpp + ">()";
        case TypeKind::Bits: return "RTT::types::shownAsDigits<" + use.cpp + ">()";
        default: return "";
    }
}

bool isShown(TypeKind kind) {
    return kind == TypeKind::Count || kind == TypeKind::Bits || kind == TypeKind::Character ||
           kind == TypeKind::LongDouble;
}

}  // namespace

std::string alternativeName(const TypeUse& use) {
    if (use.kind == TypeKind::Nothing) return "none";
    if (use.cpp.compare(0, 2, "::") == 0) return use.cpp.substr(2);
    return use.cpp.compare(0, 5, "std::") == 0 ? use.cpp.substr(5) : use.cpp;
}

std::string entryName(const TypeUse& map) {
    return "/KeyValue<" + map.element[0].name + "," + map.element[1].name + ">";
}

json entryView(const TypeUse& map) {
    const std::string cpp = "RTT::types::KeyValue<" + map.element[0].cpp + ", " + map.element[1].cpp + ">";
    return twoFields(cpp, entryName(map), "key", map.element[0], "value", map.element[1]);
}

json libraryView(const TypeUse& use) {
    if (use.kind == TypeKind::Tuple) return tupleView(use);
    if (use.kind == TypeKind::Pair)
        return twoFields(use.cpp, use.name, "first", use.element[0], "second", use.element[1]);
    if (use.kind == TypeKind::Complex) {
        // The standard guarantees two numbers, one after the other.
        return structView(
            use.cpp, use.name,
            {field("real", "0", use.element[0]), field("imag", "sizeof(" + use.element[0].cpp + ")", use.element[0])});
    }
    json view = {{"cpp", use.cpp}, {"name", cppString(use.name)}, {"maker", "makeSequenceType"}};
    const std::string table = tableFor(use);
    view["arguments"] = table.empty() ? "" : ", " + table;
    if (isShown(use.kind)) view["maker"] = "makeShownType";
    if (use.kind == TypeKind::Count) view["arguments"] = ", " + table + ", " + cppString("in " + use.unit);
    if (use.kind == TypeKind::Variant) {
        view["maker"] = "makeVariantType";
        view["arguments"] = ", alternatives";
        std::string labels;
        for (const TypeUse& alternative : use.element)
            labels += (labels.empty() ? "" : ", ") + cppString(alternativeName(alternative));
        view["labels"] = labels;
    }
    return view;
}

std::string libraryHeader(TypeKind kind) {
    if (isShown(kind)) return "rtt/types/ShownTable.hpp";
    switch (kind) {
        case TypeKind::Linked:
        case TypeKind::Set:
        case TypeKind::Map:
        case TypeKind::Optional: return "rtt/types/ContainerTable.hpp";
        case TypeKind::Variant: return "rtt/types/VariantTable.hpp";
        case TypeKind::Tuple: return "tuple";
        default: return "";
    }
}

}  // namespace oroforge::typekit
