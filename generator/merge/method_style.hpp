// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// How the user writes methods: taken from those that are there.
#ifndef OROFORGE_GENERATOR_MERGE_METHOD_STYLE_HPP
#define OROFORGE_GENERATOR_MERGE_METHOD_STYLE_HPP

#include <string>
#include <vector>

#include <merge/wanted.hpp>
#include <model/user_code.hpp>

namespace oroforge::merge {

struct MethodStyle {
    std::string lineEnd = "\n";
    std::string indent;              ///< of the method
    std::string unit = "    ";       ///< of what stands in it
    std::string behindReturn = " ";  ///< between type and name
    std::string beforeBracket;       ///< between name and '('
    std::string padding;             ///< inside of the brackets
    std::string comma = ", ";
    std::string beforeBrace = " ";  ///< what stands between ')' and '{'
    std::string docMark = "///";    ///< "/**" for block comments
    bool saysVirtual = false;
    bool saysOverride = true;
    bool blankLine = true;  ///< between methods
};

/// Of declarations in the class; `near` is the one it will stand beside, or nothing.
MethodStyle declarationStyle(const std::string& text, const model::UserClass& type, const model::UserFunction* near);

/// Of definitions in `file`.
MethodStyle definitionStyle(const std::string& text, const model::UserClass& type, const std::string& file,
                            const model::UserFunction* near);

/// Indentation of one level, as the class has it.
std::string indentUnit(const std::string& text, const model::UserClass& type);

/// "virtual bool finish(int sent) override" with its comment lines above, each line with its end.
std::string declarationText(const MethodStyle& style, const WantedMethod& method, bool overrides);

/// The whole definition. `qualifier` stands before its name, as "Plant::".
std::string definitionText(const MethodStyle& style, const WantedMethod& method, const std::string& qualifier,
                           bool trailingReturn);

/// The definition inside of the class.
std::string inlineText(const MethodStyle& style, const WantedMethod& method, bool overrides);

/// Whether a type has names in it that are only known in the class's namespace `home`.
bool needsNamespace(const std::string& type, const std::string& home);

/// The line without what would end a comment of /* and */.
std::string inBlockComment(std::string line);

std::vector<std::string> commentText(const MethodStyle& style, const std::vector<std::string>& lines);

}  // namespace oroforge::merge

#endif
