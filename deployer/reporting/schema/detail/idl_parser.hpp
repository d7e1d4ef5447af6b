// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_IDL_PARSER_HPP
#define OROFORGE_SCHEMA_IDL_PARSER_HPP

#include "idl_names.hpp"
#include "idl_reader.hpp"

#include <string>
#include <vector>

namespace oroforge::schema {

/** A field before the names of types are looked up. */
struct IdlField {
    Field field;
    IdlType type;
};

struct IdlStruct {
    Struct its;
    std::vector<IdlField> fields;
    std::string base, scope;
    IdlType discriminator;  // of a union
    std::size_t line = 0;
};

/** Reads the definitions of a text. */
class IdlParser {
public:
    IdlParser(IdlReader& reader, IdlNames& names, std::vector<IdlStruct>& structs)
        : reader_(reader), names_(names), structs_(structs) {}

    /** All of them. False if there is an error, which the reader has. */
    bool definitions() {
        while (!reader_.isEnd())
            if (!definition()) return false;
        return true;
    }

private:
    bool definition();
    bool moduleOf();
    bool structOf();
    bool unionOf();
    bool unionCase(IdlStruct& its);
    bool enumOf(unsigned bits);
    bool constant();
    bool typedefOf();
    bool type(IdlType& result);
    bool basicType(IdlType& result);
    bool limit();
    /** Names with arrays, separated by commas, up to a semicolon. */
    template <class Use>
    bool declarators(const IdlType& type, Use&& use);
    bool addType(const std::string& name, std::size_t line);
    IdlStruct& newStruct(const std::string& name, std::size_t line);

    IdlReader& reader_;
    IdlNames& names_;
    std::vector<IdlStruct>& structs_;
    std::string scope_;
    std::size_t depth_ = 0, fields_ = 0;
};

}  // namespace oroforge::schema

#endif
