// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/wire.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>

#include <model/shown_name.hpp>

namespace oroforge::messages {

namespace {

using model::TypeKind;
using model::TypeUse;
using Wires = std::vector<Wire>;

/// By the name in the type registry, which is the same for all names that C++ has for a number.
std::string wordOf(const std::string& registryName) {
    static const std::map<std::string, std::string> all = {
        {"/bool", "bool"},     {"/char", "char"},       {"/int8_t", "int8"},     {"/uint8_t", "uint8"},
        {"/int16_t", "int16"}, {"/uint16_t", "uint16"}, {"/int32_t", "int32"},   {"/uint32_t", "uint32"},
        {"/int64_t", "int64"}, {"/uint64_t", "uint64"}, {"/llong", "int64"},     {"/ullong", "uint64"},
        {"/long", "int32"},    {"/ulong", "uint32"},    {"/float", "float32"},   {"/double", "float64"},
        {"/byte", "uint8"},    {"/wchar_t", "int32"},   {"/char16_t", "uint16"}, {"/char32_t", "int32"},
    };
    const auto found = all.find(registryName);
    return found == all.end() ? "" : found->second;
}

std::string wordOf(const model::Enum& type) {
    if (type.underlying == "bool" || type.underlying == "char") return type.underlying;
    return (type.underlying.compare(0, 8, "unsigned") == 0 ? "uint" : "int") + std::to_string(8 * type.size);
}

/// Digits at the end of "std::array<double, 3>".
std::uint64_t countOf(const std::string& stdArray) {
    return std::strtoull(stdArray.c_str() + stdArray.rfind(", ") + 2, nullptr, 10);
}

class StructWire {
public:
    explicit StructWire(const model::TypeModel& model) : model_(model) {}

    void addFields(const model::Struct& type, const std::string& path, Wires& to) {
        open_.push_back(type.name);
        const bool isOutermost = open_.size() == 1;
        for (const model::Field& field : type.fields) {
            if (field.access.isConstant()) continue;
            if (isOutermost) where_ = field.where;
            const std::string its = path.empty() ? field.name : path + "." + field.name;
            if (field.count == 0)
                add(field.type, its, to);
            else
                add(Wire::Kind::Row, field.count, {field.type}, its, to);
        }
        open_.pop_back();
    }

private:
    void addWord(const std::string& word, const std::string& path, Wires& to) {
        to.push_back({Wire::Kind::Value, word, 0, {}, path, where_});
    }
    void addNone(const std::string& why, const std::string& path, Wires& to) {
        to.push_back({Wire::Kind::None, why, 0, {}, path, where_});
    }

    void add(Wire::Kind kind, std::uint64_t count, const std::vector<TypeUse>& parts, const std::string& path,
             Wires& to) {
        Wire wire{kind, "", count, {}, path, where_};
        for (const TypeUse& part : parts) add(part, path + "[]", wire.parts);
        to.push_back(std::move(wire));
    }

    void add(const TypeUse& use, const std::string& path, Wires& to) {
        switch (use.kind) {
            case TypeKind::Scalar:
            case TypeKind::Character: return addNumber(use, path, to);
            case TypeKind::String:
            case TypeKind::Bits:
            case TypeKind::LongDouble: return addWord("string", path, to);
            case TypeKind::Enum: return addEnum(use, path, to);
            case TypeKind::Struct: return addStruct(use, path, to);
            case TypeKind::Sequence: {
                const bool isArray = use.cpp.compare(0, 11, "std::array<") == 0;
                return add(isArray ? Wire::Kind::Row : Wire::Kind::List, isArray ? countOf(use.cpp) : 0, use.element,
                           path, to);
            }
            case TypeKind::Linked:
            case TypeKind::Set:
            case TypeKind::Map:
            case TypeKind::Optional: return add(Wire::Kind::List, 0, use.element, path, to);
            case TypeKind::Pair:
            case TypeKind::Tuple: return addParts(use.element, path, to);
            case TypeKind::Complex: return addParts({use.element[0], use.element[0]}, path, to);
            case TypeKind::Count: return add(use.element[0], path, to);
            case TypeKind::Variant: return addNone("messages have no alternatives", path, to);
            case TypeKind::Nothing: return addNone("it has no value", path, to);
        }
    }

    void addParts(const std::vector<TypeUse>& parts, const std::string& path, Wires& to) {
        for (std::size_t i = 0; i != parts.size(); ++i) add(parts[i], path + "._" + std::to_string(i), to);
    }
    void addNumber(const TypeUse& use, const std::string& path, Wires& to) {
        const std::string word = wordOf(use.name);
        if (word.empty()) return addNone("no message has a '" + use.cpp + "'", path, to);
        addWord(word, path, to);
    }
    void addEnum(const TypeUse& use, const std::string& path, Wires& to) {
        for (const model::Enum& type : model_.enums)
            if (type.cpp == use.cpp) return addWord(wordOf(type), path, to);
        addNone("nothing is known of '" + model::cppShown(use.cpp) + "'", path, to);
    }

    void addStruct(const TypeUse& use, const std::string& path, Wires& to) {
        if (std::find(open_.begin(), open_.end(), use.name) != open_.end())
            return addNone("a '" + model::cppShown(use.cpp) + "' is in itself, and no message is", path, to);
        for (const model::Struct& type : model_.structs)
            if (type.cpp == use.cpp) return addFields(type, path, to);
        for (const model::Adapted& type : model_.adapted)
            if (type.cpp == use.cpp) return addAdapted(type, path, to);
        addNone("nothing is known of '" + model::cppShown(use.cpp) + "'", path, to);
    }

    /// A matrix is a row of rows. One that does not change has a size that only its program knows.
    void addAdapted(const model::Adapted& type, const std::string& path, Wires& to) {
        const bool isFixed = type.resize.empty();
        if (isFixed && !isNumber(type.count))
            return addNone("the size of a '" + model::cppShown(type.cpp) + "' is not known here", path, to);
        const TypeUse& element = type.columns.empty() ? type.element : type.row;
        add(isFixed ? Wire::Kind::Row : Wire::Kind::List, isFixed ? std::strtoull(type.count.c_str(), nullptr, 10) : 0,
            {element}, path, to);
    }
    static bool isNumber(const std::string& text) { return text.find_first_not_of("0123456789") == std::string::npos; }

    const model::TypeModel& model_;
    std::vector<std::string> open_;
    diag::Location where_;
};

std::string wordOfBuiltin(const std::string& type) {
    if (type == "byte") return "int8";
    return type == "char" ? "uint8" : type;
}

void addValue(const Field& field, const MessageSet& set, const std::string& path, Wires& to) {
    if (!field.type.isBuiltin) {
        for (Wire& part : wireOf(*set.find(field.type.name), set)) {
            part.path = path + "." + part.path;
            to.push_back(std::move(part));
        }
        return;
    }
    if (field.type.name != "time" && field.type.name != "duration") {
        to.push_back({Wire::Kind::Value, wordOfBuiltin(field.type.name), 0, {}, path, field.where});
        return;
    }
    // Their sign is not looked at.
    for (const char* part : {".sec", ".nsec"})
        to.push_back({Wire::Kind::Value, "word", 0, {}, path + part, field.where});
}

}  // namespace

std::vector<Wire> wireOf(const model::Struct& type, const model::TypeModel& model) {
    Wires all;
    StructWire(model).addFields(type, "", all);
    return all;
}

std::vector<Wire> wireOf(const Message& message, const MessageSet& set) {
    Wires all;
    for (const Field& field : message.fields) {
        if (field.extent == Extent::Single) {
            addValue(field, set, field.name, all);
            continue;
        }
        if (field.extent == Extent::Fixed && field.count == 0) continue;  // it has no bytes
        Wire wire{field.extent == Extent::Fixed ? Wire::Kind::Row : Wire::Kind::List,
                  "",
                  field.count,
                  {},
                  field.name,
                  field.where};
        addValue(field, set, field.name + "[]", wire.parts);
        all.push_back(std::move(wire));
    }
    return all;
}

}  // namespace oroforge::messages
