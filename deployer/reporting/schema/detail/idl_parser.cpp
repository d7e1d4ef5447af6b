// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "idl_parser.hpp"

#include "idl_number.hpp"
#include "limits.hpp"

#include <utility>

namespace oroforge::schema {

bool IdlParser::definition() {
    if (!reader_.skipAnnotations()) return false;
    const unsigned bits = reader_.bitBound();
    if (reader_.accept(";")) return true;
    if (reader_.accept("module")) return moduleOf();
    if (reader_.accept("struct")) return structOf();
    if (reader_.accept("union")) return unionOf();
    if (reader_.accept("enum")) return enumOf(bits);
    if (reader_.accept("const")) return constant();
    if (reader_.accept("typedef")) return typedefOf();
    return reader_.failAt("'module', 'struct', 'union', 'enum', 'const' or 'typedef'");
}

bool IdlParser::moduleOf() {
    std::string name;
    if (depth_ == kDeepest) return reader_.fail("modules nest too deeply");
    if (!reader_.expectName(name) || !reader_.expect("{")) return false;
    const std::string around = scope_;
    scope_ += name + "::";
    ++depth_;
    while (!reader_.is("}"))
        if (!definition()) return false;
    --depth_;
    scope_ = around;
    return reader_.expect("}");
}

bool IdlParser::addType(const std::string& name, std::size_t line) {
    return names_.types.count(scope_ + name) == 0 ||
           reader_.fail(line, "the type '" + scope_ + name + "' is described twice");
}

IdlStruct& IdlParser::newStruct(const std::string& name, std::size_t line) {
    names_.types[scope_ + name] = {true, structs_.size(), {}};
    structs_.emplace_back();
    structs_.back().its.name = scope_ + name;
    structs_.back().scope = scope_ + name + "::";
    structs_.back().line = line;
    return structs_.back();
}

bool IdlParser::structOf() {
    std::string name;
    const std::size_t line = reader_.next().line;
    if (!reader_.expectName(name)) return false;
    if (reader_.accept(";")) return true;  // it is described later
    if (!addType(name, line)) return false;
    IdlStruct& its = newStruct(name, line);
    if (reader_.accept(":")) {
        if (reader_.next().kind != IdlToken::Name) return reader_.failAt("the name of a struct");
        its.base = reader_.take().text;
    }
    if (!reader_.expect("{")) return false;
    while (!reader_.accept("}")) {
        IdlType fieldType;
        if (!reader_.skipAnnotations() || !type(fieldType)) return false;
        const bool isGood = declarators(fieldType, [&](const std::string& field, IdlType its_type) {
            IdlField one;
            one.field.name = field;
            one.type = std::move(its_type);
            its.fields.push_back(std::move(one));
            return true;
        });
        if (!isGood) return false;
    }
    return reader_.expect(";");
}

bool IdlParser::unionOf() {
    std::string name;
    const std::size_t line = reader_.next().line;
    if (!reader_.expectName(name)) return false;
    if (reader_.accept(";")) return true;
    if (!addType(name, line)) return false;
    IdlStruct& its = newStruct(name, line);
    its.its.isUnion = true;
    if (!reader_.expect("switch") || !reader_.expect("(") || !reader_.skipAnnotations() || !type(its.discriminator) ||
        !reader_.expect(")") || !reader_.expect("{"))
        return false;
    while (!reader_.accept("}"))
        if (!unionCase(its)) return false;
    return reader_.expect(";");
}

bool IdlParser::unionCase(IdlStruct& its) {
    IdlField one;
    bool hasLabel = false;
    while (reader_.skipAnnotations()) {
        if (reader_.accept("default")) {
            one.field.isDefault = true;
        } else if (reader_.accept("case")) {
            std::int64_t label = 0;
            // The enumerators of the discriminator's type are around the type.
            std::string scope = its.discriminator.name;
            const std::size_t last = scope.rfind("::");
            scope = last == std::string::npos ? scope_ : scope_ + scope.substr(0, last + 2);
            if (!readNumber(reader_, names_, scope, label)) return false;
            one.field.labels.push_back(label);
        } else {
            break;
        }
        hasLabel = true;
        if (!reader_.expect(":")) return false;
    }
    if (reader_.failed()) return false;
    if (!hasLabel) return reader_.failAt("'case' or 'default'");
    IdlType fieldType;
    return type(fieldType) && declarators(fieldType, [&](const std::string& field, IdlType its_type) {
               one.field.name = field;
               one.type = std::move(its_type);
               its.fields.push_back(one);
               return true;
           });
}

bool IdlParser::enumOf(unsigned bits) {
    std::string name;
    const std::size_t line = reader_.next().line;
    if (!reader_.expectName(name) || !addType(name, line) || !reader_.expect("{")) return false;
    Basic& basic = names_.types[scope_ + name].other.basic;
    if (bits == 0 || bits > 16)
        basic = Basic::Int32;
    else
        basic = bits > 8 ? Basic::Int16 : Basic::Int8;
    std::int64_t value = 0;
    while (!reader_.is("}")) {
        std::string enumerator;
        if (!reader_.skipAnnotations() || !reader_.expectName(enumerator)) return false;
        if (reader_.accept("=") && !readNumber(reader_, names_, scope_, value)) return false;
        names_.constants[scope_ + enumerator] = value;
        names_.constants[scope_ + name + "::" + enumerator] = value;
        value = static_cast<std::int64_t>(static_cast<std::uint64_t>(value) + 1);
        if (!reader_.accept(",") && !reader_.is("}")) return reader_.failAt("',' or '}'");
    }
    return reader_.expect("}") && reader_.expect(";");
}

bool IdlParser::constant() {
    IdlType its;
    std::string name;
    if (!type(its) || !reader_.expectName(name) || !reader_.expect("=")) return false;
    const bool isOther = reader_.next().kind == IdlToken::Text || its.basic == Basic::Text ||
                         its.basic == Basic::WideText || its.basic == Basic::Float32 || its.basic == Basic::Float64;
    // Nothing that is read depends on them.
    if (isOther) return reader_.skipTo(";") && reader_.expect(";");
    std::int64_t value = 0;
    if (!readNumber(reader_, names_, scope_, value)) return false;
    names_.constants[scope_ + name] = value;
    return reader_.expect(";");
}

bool IdlParser::typedefOf() {
    IdlType its;
    if (!reader_.skipAnnotations() || !type(its)) return false;
    return declarators(its, [&](const std::string& name, IdlType type) {
        if (!addType(name, type.line)) return false;
        names_.types[scope_ + name] = {false, 0, std::move(type)};
        return true;
    });
}

template <class Use>
bool IdlParser::declarators(const IdlType& type, Use&& use) {
    do {
        std::string name;
        if (!reader_.skipAnnotations() || !reader_.expectName(name)) return false;
        std::vector<Many> arrays;
        while (reader_.accept("[")) {
            const std::size_t line = reader_.next().line;
            std::int64_t count = 0;
            if (!readNumber(reader_, names_, scope_, count) || !reader_.expect("]")) return false;
            if (count < 1 || static_cast<std::uint64_t>(count) > kLongest)
                return reader_.fail(line, "an array of " + std::to_string(count) + " elements cannot be read");
            arrays.push_back({false, static_cast<std::size_t>(count)});
        }
        IdlType whole = type;
        whole.lists.insert(whole.lists.begin(), arrays.begin(), arrays.end());
        if (whole.lists.size() > kMostLists) return reader_.fail("lists nest too deeply");
        if (++fields_ > kMostFields) return reader_.fail("there are too many fields");
        if (!use(name, std::move(whole))) return false;
    } while (reader_.accept(","));
    return reader_.expect(";");
}

}  // namespace oroforge::schema
