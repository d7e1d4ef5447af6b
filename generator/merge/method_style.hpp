// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds out how the user writes methods from those that exist.
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
    std::string unit = "    ";       ///< of the lines in the method
    std::string behindReturn = " ";  ///< between type and name
    std::string beforeBracket;       ///< between name and '('
    std::string padding;             ///< inside the brackets
    std::string comma = ", ";
    std::string beforeBrace = " ";  ///< between ')' and '{'
    std::string docMark = "///";    ///< "/**" for block comments
    bool saysVirtual = false;
    bool saysOverride = true;
    bool blankLine = true;  ///< between methods
};

/// Returns the style of declarations in the class; `near` is the one beside the new one, or null.
MethodStyle declarationStyle(const std::string& text, const model::UserClass& type, const model::UserFunction* near);

/// Returns the style of definitions in `file`.
MethodStyle definitionStyle(const std::string& text, const model::UserClass& type, const std::string& file,
                            const model::UserFunction* near);

/// Returns the indentation of one level in the class.
std::string indentUnit(const std::string& text, const model::UserClass& type);

/// Returns "virtual bool finish(int sent) override" with its comment lines above, each with its line end.
std::string declarationText(const MethodStyle& style, const WantedMethod& method, bool overrides);

/// Returns the whole definition. `qualifier`, such as "Plant::", goes before its name.
std::string definitionText(const MethodStyle& style, const WantedMethod& method, const std::string& qualifier,
                           bool trailingReturn);

/// Returns the definition inside the class.
std::string inlineText(const MethodStyle& style, const WantedMethod& method, bool overrides);

/// True if a type contains names that are known only in the class's namespace `home`.
bool needsNamespace(const std::string& type, const std::string& home);

/// Returns the line without anything that would end a block comment.
std::string inBlockComment(std::string line);

std::vector<std::string> commentText(const MethodStyle& style, const std::vector<std::string>& lines);

}  // namespace oroforge::merge

#endif
