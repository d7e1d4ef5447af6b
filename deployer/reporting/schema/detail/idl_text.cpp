// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "idl_text.hpp"

#include "idl_parser.hpp"
#include "limits.hpp"

#include <utility>

namespace oroforge::schema {
namespace {

/** Replaces names of types by what they mean. */
class IdlResolver {
public:
    IdlResolver(IdlReader& reader, IdlNames& names, std::vector<IdlStruct>& structs)
        : reader_(reader), names_(names), structs_(structs) {}

    bool resolve(std::vector<Struct>& result) {
        result.clear();
        states_.assign(structs_.size(), State::New);
        for (std::size_t at = 0; at != structs_.size(); ++at)
            if (!addBase(at, 0)) return false;
        for (IdlStruct& one : structs_) {
            if (one.its.isUnion && !discriminator(one)) return false;
            for (IdlField& field : one.fields) {
                if (!place(field)) return false;
                one.its.fields.push_back(std::move(field.field));
            }
            result.push_back(one.its);  // later fields need its name
        }
        return true;
    }

private:
    enum class State : std::uint8_t { New, Open, Done };

    /** The fields of the base come first. */
    bool addBase(std::size_t at, std::size_t depth) {
        IdlStruct& its = structs_[at];
        if (states_[at] == State::Done) return true;
        if (states_[at] == State::Open || depth == kDeepest)
            return reader_.fail(its.line, "the bases of '" + its.its.name + "' have no end");
        states_[at] = State::Open;
        if (!its.base.empty()) {
            const auto found = findName(names_.types, its.scope, its.base);
            const bool isStruct = found != names_.types.end() && found->second.isStruct;
            if (!isStruct || structs_[found->second.structAt].its.isUnion)
                return reader_.fail(its.line, "the base '" + its.base + "' is not a struct that is described");
            if (!addBase(found->second.structAt, depth + 1)) return false;
            const std::vector<IdlField>& more = structs_[found->second.structAt].fields;
            if ((inherited_ += more.size()) > kMostFields) return reader_.fail(its.line, "there are too many fields");
            its.fields.insert(its.fields.begin(), more.begin(), more.end());
        }
        states_[at] = State::Done;
        return true;
    }

    /** Follows other names of a type. `structAt` becomes the index of a struct. */
    bool follow(IdlType& type, std::size_t& structAt) {
        const std::string used = type.name;
        for (std::size_t steps = 0; type.basic == Basic::Struct; ++steps) {
            const auto found = findName(names_.types, type.scope, type.name);
            if (found == names_.types.end()) return reader_.fail(type.line, "the type '" + used + "' is not described");
            if (found->second.isStruct) {
                structAt = found->second.structAt;
                return true;
            }
            const IdlType& meant = found->second.other;
            if (steps == kDeepest || type.lists.size() + meant.lists.size() > kMostLists)
                return reader_.fail(type.line, "the type '" + used + "' is another name of another name without end");
            type.lists.insert(type.lists.end(), meant.lists.begin(), meant.lists.end());
            type.basic = meant.basic;
            type.name = meant.name;
            type.scope = meant.scope;
        }
        return true;
    }

    bool place(IdlField& one) {
        Field& field = one.field;
        if (!follow(one.type, field.structAt)) return false;
        field.basic = one.type.basic;
        field.lists = one.type.lists;
        field.line = one.type.line;
        if (field.basic == Basic::Struct) field.type = structs_[field.structAt].its.name;
        return true;
    }

    bool discriminator(IdlStruct& its) {
        IdlType& type = its.discriminator;
        std::size_t none = 0;
        if (!follow(type, none)) return false;
        const bool isInteger = type.basic != Basic::Struct && type.basic != Basic::Float32 &&
                               type.basic != Basic::Float64 && type.basic != Basic::Text &&
                               type.basic != Basic::WideText && type.lists.empty();
        its.its.discriminator = type.basic;
        return isInteger || reader_.fail(type.line, "the type behind 'switch' is not an integer or enum");
    }

    IdlReader& reader_;
    IdlNames& names_;
    std::vector<IdlStruct>& structs_;
    std::vector<State> states_;
    std::size_t inherited_ = 0;
};

/** "tank/msg/Level" is "tank::msg::Level". */
std::string idlNameOf(const std::string& name) {
    std::string result;
    for (const char c : name) result += c == '/' ? std::string("::") : std::string(1, c);
    return result.substr(0, 2) == "::" ? result.substr(2) : result;
}

}  // namespace

bool readIdl(const std::string& text, const std::string& name, std::vector<Struct>& structs, std::size_t& root,
             std::string& why) {
    std::vector<IdlToken> tokens;
    if (!readTokens(text, tokens, why)) return false;
    IdlReader reader(std::move(tokens));
    IdlNames names;
    std::vector<IdlStruct> all;
    if (!IdlParser(reader, names, all).definitions() || !IdlResolver(reader, names, all).resolve(structs)) {
        why = reader.why();
        return false;
    }
    const auto found = names.types.find(idlNameOf(name));
    if (found == names.types.end() || !found->second.isStruct) {
        why = "the text does not describe the type '" + name + "'";
        return false;
    }
    root = found->second.structAt;
    return true;
}

}  // namespace oroforge::schema
