// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "idl_reader.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace oroforge::schema {

bool isIdlKeyword(std::string_view name) {
    static const std::string_view kKeywords[] = {
        "FALSE",  "TRUE",    "boolean", "byte",   "case",   "char",   "const", "default",  "double", "enum",   "float",
        "int16",  "int32",   "int64",   "int8",   "long",   "module", "octet", "sequence", "short",  "string", "struct",
        "switch", "typedef", "uint16",  "uint32", "uint64", "uint8",  "union", "unsigned", "wchar",  "wstring"};
    return std::find(std::begin(kKeywords), std::end(kKeywords), name) != std::end(kKeywords);
}

bool IdlReader::expectName(std::string& name) {
    const IdlToken& token = next();
    if (token.kind != IdlToken::Name || token.text.find(':') != std::string_view::npos || isIdlKeyword(token.text))
        return failAt("a name");
    std::string_view text = token.text;
    if (text.front() == '_' && isIdlKeyword(text.substr(1))) text.remove_prefix(1);
    name = text;
    ++at_;
    return true;
}

bool IdlReader::skipAnnotations() {
    bitBound_ = 0;
    while (accept("@")) {
        const IdlToken name = take();
        if (name.kind != IdlToken::Name)
            return fail(name.line, "found '@', expected the name of an annotation behind it");
        if (name.text == "optional") return fail(name.line, "optional fields are not read");
        if (!accept("(")) continue;
        if (name.text == "bit_bound") {
            const std::string_view bits = accept("value") && accept("=") ? next().text : next().text;
            const auto end = std::from_chars(bits.data(), bits.data() + bits.size(), bitBound_).ptr;
            if (end != bits.data() + bits.size() || bitBound_ == 0 || bitBound_ > 64)
                return failAt("a number of bits from 1 to 64");
        }
        if (!skipTo(")")) return false;
        take();
    }
    return true;
}

bool IdlReader::skipTo(std::string_view sign) {
    std::size_t open = 0;
    for (; !isEnd(); ++at_) {
        if (open == 0 && is(sign) && next().kind == IdlToken::Sign) return true;
        if (is("(") || is("[") || is("{")) ++open;
        if (open != 0 && (is(")") || is("]") || is("}"))) --open;
    }
    return failAt("'" + std::string(sign) + "'");
}

bool IdlReader::failAt(const std::string& expected) {
    return fail(isEnd() ? "the text ends, expected " + expected
                        : "found '" + std::string(next().text.substr(0, 60)) + "', expected " + expected);
}

}  // namespace oroforge::schema
