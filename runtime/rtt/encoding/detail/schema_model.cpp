// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/detail/schema_model.hpp>

#include <rtt/types/StructTable.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <cctype>
#include <typeinfo>
#include <utility>

namespace RTT::encoding::detail {

using types::Shape;

namespace {

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }

/** A name with nothing but letters, digits and underscores that does not begin with a digit. */
std::string identifier(const std::string& text) {
    std::string name;
    for (const char c : text) name += isLetter(c) || isDigit(c) ? c : '_';
    return name.empty() || isDigit(name[0]) ? "_" + name : name;
}

std::string typeNameOf(const Form& form) {
    const types::TypeInfo* const type = types::Types()->getTypeById(form.shape.ops->id->name());
    return type ? type->getTypeName() : "unknown";
}

/** "/tank/Level" and "tank::Level<double, 2>" have two parts. */
std::vector<std::string> partsOf(const std::string& name) {
    std::vector<std::string> parts;
    std::string part;
    const std::size_t end = name.find('<');
    for (const char c : name.substr(0, end)) {
        if (c != '/' && c != ':' && c != '.') {
            part += c;
        } else if (!part.empty()) {
            parts.push_back(std::exchange(part, ""));
        }
    }
    if (end != std::string::npos) part += name.substr(end);
    if (!part.empty()) parts.push_back(part);
    for (std::string& one : parts) {
        one = identifier(one);
        while (one.size() > 1 && one.back() == '_') one.pop_back();
    }
    return parts.empty() ? std::vector<std::string>{"unknown"} : parts;
}

/** Those whose bytes are those of a message of std_msgs. */
const char* standardName(const Form& form) {
    if (form.shape.kind == Shape::Kind::Text) return "String";
    if (form.shape.kind != Shape::Kind::Number) return nullptr;
    switch (form.shape.number) {
        case Shape::Number::Bool: return "Bool";
        case Shape::Number::Char: return "Char";
        case Shape::Number::Int8: return "Int8";
        case Shape::Number::UInt8: return "UInt8";
        case Shape::Number::Int16: return "Int16";
        case Shape::Number::UInt16: return "UInt16";
        case Shape::Number::Int32: return "Int32";
        case Shape::Number::UInt32: return "UInt32";
        case Shape::Number::Int64: return "Int64";
        case Shape::Number::UInt64: return "UInt64";
        case Shape::Number::Float32: return "Float32";
        case Shape::Number::Float64: return "Float64";
    }
    return nullptr;
}

const Form& withoutShown(const Form& form) { return form.shown ? withoutShown(*form.shown) : form; }

}  // namespace

const char* sharedNameOf(Shape::Number number) {
    switch (number) {
        case Shape::Number::Char: return "char";
        case Shape::Number::Int8: return "int8";
        case Shape::Number::UInt8: return "uint8";
        case Shape::Number::Int16: return "int16";
        case Shape::Number::UInt16: return "uint16";
        case Shape::Number::Int32: return "int32";
        case Shape::Number::UInt32: return "uint32";
        case Shape::Number::Int64: return "int64";
        case Shape::Number::UInt64: return "uint64";
        default: return nullptr;
    }
}

types::Shape::Number numberOf(const Form& basic) {
    if (basic.shape.kind == Shape::Kind::Number) return basic.shape.number;
    if (basic.hasBool) return Shape::Number::Bool;
    const bool isUnsigned = basic.shape.numbers->isUnsigned;
    switch (basic.numberSize) {
        case 1: return isUnsigned ? Shape::Number::UInt8 : Shape::Number::Int8;
        case 2: return isUnsigned ? Shape::Number::UInt16 : Shape::Number::Int16;
        case 4: return isUnsigned ? Shape::Number::UInt32 : Shape::Number::Int32;
        default: return isUnsigned ? Shape::Number::UInt64 : Shape::Number::Int64;
    }
}

std::string oneLine(const char* text) {
    std::string line;
    for (; *text != '\0'; ++text) {
        const bool isBlank = static_cast<unsigned char>(*text) <= ' ';
        if (!isBlank || (!line.empty() && line.back() != ' ')) line += isBlank ? ' ' : *text;
    }
    while (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

std::string commentOf(const SchemaField& field) {
    const std::string doc = oneLine(field.doc), unit = oneLine(field.unit);
    if (unit.empty()) return doc;
    return doc + (doc.empty() ? "[" : " [") + unit + "]";
}

std::string snakeCase(const std::string& name) {
    std::string result;
    for (std::size_t i = 0; i != name.size(); ++i) {
        // "HTTPPort" is http_port, "angleRad" angle_rad.
        const bool isWord = isUpper(name[i]) && i != 0 &&
                            (!isUpper(name[i - 1]) || (i + 1 != name.size() && std::islower(name[i + 1]) != 0));
        if (isWord || !(isLetter(name[i]) || isDigit(name[i])))
            if (!result.empty() && result.back() != '_') result += '_';
        if (isLetter(name[i]) || isDigit(name[i]))
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
    }
    while (!result.empty() && result.back() == '_') result.pop_back();
    return result.empty() || isDigit(result[0]) ? "x" + result : result;
}

std::string valueText(const Shape::Enumerator& one, const Form& enumeration) {
    return enumeration.shape.numbers->isUnsigned ? std::to_string(static_cast<unsigned long long>(one.value))
                                                 : std::to_string(one.value);
}

std::vector<std::string> pathOf(const Form& form) { return partsOf(typeNameOf(form)); }

SchemaModel::SchemaModel(const Form& root) {
    const Form& form = withoutShown(root);
    if (form.shape.kind == Shape::Kind::Struct) {
        root_ = structOf(form);
        return;
    }
    // A message cannot be a number, a list or a union.
    const char* const standard = standardName(form);
    SchemaStruct& its = standard ? newStruct({"std_msgs"}, standard) : newStruct(typeNameOf(root));
    add(its, "data", form, 0, "", "");
    order_.push_back(&its);
    root_ = &its;
}

SchemaStruct& SchemaModel::newStruct(std::vector<std::string> path, const std::string& name) {
    all_.emplace_back();
    SchemaStruct& its = all_.back();
    its.path = std::move(path);
    its.name = name;
    for (unsigned number = 2; !names_.insert(rosName(its, "/")).second; ++number)
        its.name = name + "_" + std::to_string(number);
    return its;
}

SchemaStruct& SchemaModel::newStruct(const std::string& typeName) {
    std::vector<std::string> parts = partsOf(typeName);
    const std::string name = parts.back();
    parts.pop_back();
    if (parts.empty()) parts.emplace_back("oroforge");
    return newStruct(parts, name);
}

const SchemaStruct* SchemaModel::again(const SchemaStruct* known) {
    if (unfinished_.count(known) != 0) recursive_ = known;
    return known;
}

const SchemaStruct* SchemaModel::finished(SchemaStruct& its) {
    unfinished_.erase(&its);
    order_.push_back(&its);
    return &its;
}

const SchemaStruct* SchemaModel::structOf(const Form& form) {
    const auto [entry, isNew] = known_.emplace(&form, nullptr);
    if (!isNew) return again(entry->second);
    SchemaStruct& its = newStruct(typeNameOf(form));
    entry->second = &its;
    unfinished_.insert(&its);
    if (form.shape.kind == Shape::Kind::Variant) return variantOf(form, its);
    its.hasByte = form.steps.empty();
    for (const FormField& field : form.fields) add(its, field.name, *field.form, field.count, field.doc, field.unit);
    return finished(its);
}

const SchemaStruct* SchemaModel::variantOf(const Form& form, SchemaStruct& its) {
    its.isUnion = true;
    for (const FormField& field : form.fields) {
        if (field.form) {
            add(its, field.name, *field.form, 0, "", "");
            continue;
        }
        its.fields.emplace_back();
        its.fields.back().name = identifier(field.name);
        its.fields.back().type = nothing();
    }
    return finished(its);
}

/** A struct without bytes, for the alternative of a variant that has no value. */
const SchemaStruct* SchemaModel::nothing() {
    if (!nothing_) order_.push_back(nothing_ = &newStruct({"oroforge"}, "Nothing"));
    return nothing_;
}

/** A struct with nothing but a list, because no language has lists of lists. */
const SchemaStruct* SchemaModel::listOf(const Form& form) {
    const auto [entry, isNew] = known_.emplace(&form, nullptr);
    if (!isNew) return again(entry->second);
    SchemaStruct& its = newStruct(typeNameOf(form));
    entry->second = &its;
    unfinished_.insert(&its);
    add(its, "data", form, 0, "", "");
    return finished(its);
}

void SchemaModel::add(SchemaStruct& to, const std::string& name, const Form& whole, std::size_t count, const char* doc,
                      const char* unit) {
    const Form& form = withoutShown(whole);
    SchemaField field;
    field.name = identifier(name);
    while (std::any_of(to.fields.begin(), to.fields.end(), [&](const auto& one) { return one.name == field.name; }))
        field.name += '_';
    field.doc = doc;
    field.unit = unit;
    field.count = count;
    if (count == 0 && form.shape.kind == Shape::Kind::Sequence) {
        if (!form.shape.elements->resize && form.fixedCount == 0) return;  // it has no bytes
        field.isSequence = form.shape.elements->resize;
        field.count = form.fixedCount;
        setType(field, withoutShown(*form.element));
    } else {
        setType(field, form);
    }
    to.fields.push_back(field);
}

void SchemaModel::setType(SchemaField& field, const Form& form) {
    switch (form.shape.kind) {
        case Shape::Kind::Struct:
        case Shape::Kind::Variant: field.type = structOf(form); break;
        case Shape::Kind::Sequence: field.type = listOf(form); break;
        default: field.basic = &form; break;
    }
}

void SchemaModel::useRosNames() {
    for (SchemaStruct& one : all_) {
        std::set<std::string> names;
        for (const SchemaField& field : one.fields) names.insert(snakeCase(field.name));
        if (names.size() != one.fields.size()) continue;
        for (SchemaField& field : one.fields) field.name = snakeCase(field.name);
    }
}

std::string SchemaModel::whyNotRos() const {
    if (recursive_) return rosName(*recursive_, "/") + " contains itself";
    for (const SchemaStruct* one : order_) {
        if (one->isUnion) return rosName(*one, "/") + " is one of several types";
        for (const SchemaField& field : one->fields)
            if (!isRosName(field.name))
                return "the field '" + field.name + "' of " + rosName(*one, "/") +
                       " has a name that is not made of small letters, digits and single '_'";
    }
    return {};
}

}  // namespace RTT::encoding::detail
