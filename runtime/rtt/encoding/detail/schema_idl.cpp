// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// IDL of OMG.
#include <rtt/encoding/detail/schema_model.hpp>

#include <algorithm>
#include <iterator>
#include <set>

namespace RTT::encoding::detail {

using types::Shape;

namespace {

/** An underscore in front of a keyword makes it a name, of which the underscore is no part. */
std::string legal(const std::string& name) {
    static const char* const keywords[] = {
        "FALSE",  "TRUE",    "boolean", "byte",   "case",   "char",   "const", "default",  "double", "enum",   "float",
        "int16",  "int32",   "int64",   "int8",   "long",   "module", "octet", "sequence", "short",  "string", "struct",
        "switch", "typedef", "uint16",  "uint32", "uint64", "uint8",  "union", "unsigned", "wchar",  "wstring"};
    const bool isKeyword = std::find(std::begin(keywords), std::end(keywords), name) != std::end(keywords);
    return isKeyword ? "_" + name : name;
}

const char* idlType(Shape::Number number) {
    switch (number) {
        case Shape::Number::Bool: return "boolean";
        case Shape::Number::Float32: return "float";
        case Shape::Number::Float64: return "double";
        default: return sharedNameOf(number);
    }
}

std::string typeOf(const SchemaField& field) {
    if (field.type) return idlName(*field.type);
    return field.basic->shape.kind == Shape::Kind::Text ? "string" : idlType(numberOf(*field.basic));
}

std::string declaration(const SchemaField& field) {
    std::string out = field.isSequence ? "sequence<" + typeOf(field) + ">" : typeOf(field);
    out += " " + legal(field.name);
    if (field.count != 0) out += "[" + std::to_string(field.count) + "]";
    return out + ";";
}

std::string lineEnd(const std::string& comment) { return comment.empty() ? "\n" : "  // " + comment + "\n"; }

/** A module has the names of all namespaces, because a type within a struct cannot be in a module of its name. */
std::string moduleOf(const std::vector<std::string>& path) {
    std::string name;
    for (const std::string& part : path) name += (name.empty() ? "" : "_") + part;
    return legal(name);
}

std::string inModule(const std::string& module, const std::string& text) {
    return "module " + module + " {\n" + text + "};\n";
}

std::string structText(const SchemaStruct& one) {
    std::string out =
        one.isUnion ? "union " + legal(one.name) + " switch (uint32) {\n" : "struct " + legal(one.name) + " {\n";
    if (one.hasByte) out += std::string("  uint8 ") + kEmptyField + ";\n";
    std::size_t number = 0;
    for (const SchemaField& field : one.fields) {
        out += one.isUnion ? "  case " + std::to_string(number++) + ": " : "  ";
        out += declaration(field) + lineEnd(commentOf(field));
    }
    return out + "};\n";
}

/** A module of constants with the name of the enumeration: an enum of IDL has 32 bits. */
std::string constantsOf(const Form& enumeration) {
    std::string out;
    std::set<std::string> names;
    for (const Shape::Enumerator& one : enumeration.shape.enumerators) {
        if (!names.insert(one.name).second) continue;
        out += std::string("  const ") + idlType(numberOf(enumeration)) + " " + legal(one.name) + " = " +
               valueText(one, enumeration) + ";" + lineEnd(oneLine(one.doc));
    }
    return out;
}

}  // namespace

std::string idlName(const SchemaStruct& one) { return moduleOf(one.path) + "::" + legal(one.name); }

std::string idlText(const SchemaModel& model) {
    std::string out;
    std::set<const Form*> enumerations;
    for (const SchemaStruct* one : model.structs()) {
        for (const SchemaField& field : one->fields) {
            const Form* const basic = field.basic;
            if (!basic || basic->shape.kind != Shape::Kind::Enumeration || basic->hasBool) continue;
            if (basic->shape.enumerators.empty() || !enumerations.insert(basic).second) continue;
            out += inModule(moduleOf(pathOf(*basic)) + "_values", constantsOf(*basic));
        }
        out += inModule(moduleOf(one->path), structText(*one));
    }
    return out;
}

}  // namespace RTT::encoding::detail
