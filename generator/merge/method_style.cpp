// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/method_style.hpp>

#include <algorithm>
#include <cctype>

#include <merge/text_places.hpp>
#include <model/cpp_type.hpp>

namespace oroforge::merge {

namespace {

using model::FunctionKind;
using model::Span;
using model::UserFunction;

bool isSample(const UserFunction& function) { return !function.isMacro && !function.isTemplate; }

bool isPlain(const UserFunction& function) {
    return isSample(function) && function.kind == FunctionKind::Method && !function.returns.empty() &&
           function.returns.end <= function.nameSpan.begin;
}

/// Returns the text if it is blank, else `usual`.
std::string gapOr(const std::string& text, std::size_t begin, std::size_t end, const std::string& usual) {
    if (begin > end) return usual;
    const std::string gap = text.substr(begin, end - begin);
    return isBlank(gap) ? gap : usual;
}

void takeSpaces(const std::string& text, const UserFunction& sample, MethodStyle& style) {
    const std::size_t name = std::min(sample.qualifier.begin, sample.nameSpan.begin);
    style.behindReturn = gapOr(text, sample.returns.end, name, " ");
    // If the type has a line of its own, the name begins in the column of the method.
    if (style.behindReturn.find('\n') != std::string::npos) style.behindReturn = style.lineEnd + style.indent;
    if (style.behindReturn.empty()) style.behindReturn = " ";
    style.beforeBracket = gapOr(text, sample.nameSpan.end, sample.brackets.begin - 1, "");
    if (sample.parameters.empty()) return;
    const std::string padding = gapOr(text, sample.brackets.begin, sample.parameters.front().whole.begin, "");
    style.padding = padding.find('\n') == std::string::npos ? padding : "";
    if (sample.parameters.size() < 2) return;
    const std::string between = cut(text, {sample.parameters[0].whole.end, sample.parameters[1].whole.begin});
    if (isBlank(between.substr(0, between.find(','))) && between.find('\n') == std::string::npos &&
        !hasComment(between))
        style.comma = between;
}

/// Returns the function nearby if it is a good example, else the first good one.
template <class Test>
const UserFunction* sampleOf(const model::UserClass& type, const UserFunction* near, Test test) {
    if (near != nullptr && test(*near)) return near;
    for (const UserFunction& function : type.functions)
        if (test(function)) return &function;
    return nullptr;
}

void takeBrace(const std::string& text, const model::UserClass& type, const std::string& file, MethodStyle& style) {
    std::size_t sameLine = 0, ownLine = 0;
    std::string gap = " ";
    for (const UserFunction& function : type.functions) {
        if (function.file != file || function.body.empty() || text[function.body.begin] != '{') continue;
        // "{}" and "{ return 1; }" say little about longer bodies.
        const bool isLong = cut(text, function.body).find('\n') != std::string::npos;
        std::size_t begin = function.body.begin;
        while (begin > 0 && std::isspace(static_cast<unsigned char>(text[begin - 1])) != 0) --begin;
        const std::string found = cut(text, {begin, function.body.begin});
        if (found.find('\n') != std::string::npos) {
            ownLine += isLong ? 2 : 1;
        } else {
            sameLine += isLong ? 2 : 1;
            if (isLong || sameLine == 1) gap = found;
        }
    }
    style.beforeBrace = ownLine > sameLine ? style.lineEnd + style.indent : gap;
}

/// Returns "/**" if the class has such comments and no "///".
std::string docMark(const std::string& text, const model::UserClass& type) {
    const std::string body = cut(text, type.whole);
    if (body.find("/// ") != std::string::npos) return "///";
    if (body.find("/**") != std::string::npos) return "/**";
    return body.find("//!") != std::string::npos ? "//!" : "///";
}

std::string withIndent(const MethodStyle& style, const std::vector<std::string>& lines) {
    std::string result;
    for (const std::string& line : lines) result += (line.empty() ? "" : style.indent + line) + style.lineEnd;
    return result;
}

std::string arguments(const MethodStyle& style, const WantedMethod& method, bool commentNames) {
    std::string list;
    for (const model::TypedName& argument : method.signature.arguments) {
        list += (list.empty() ? "" : style.comma) + argument.type;
        list += commentNames ? " /*" + argument.name + "*/" : " " + argument.name;
    }
    return "(" + (list.empty() ? "" : style.padding + list + style.padding) + ")";
}

std::string bodyText(const MethodStyle& style, const WantedMethod& method) {
    std::string result = style.beforeBrace + "{" + style.lineEnd;
    for (const std::string& line : method.body)
        result += (line.empty() ? "" : style.indent + style.unit + line) + style.lineEnd;
    return result + style.indent + "}" + style.lineEnd;
}

/// Returns a declaration up to its ';' or body.
std::string declared(const MethodStyle& style, const WantedMethod& method, bool overrides, bool commentNames) {
    return withIndent(style, commentText(style, method.comment)) + style.indent +
           (overrides && style.saysVirtual ? "virtual " : "") + method.signature.returns + style.behindReturn +
           method.name + style.beforeBracket + arguments(style, method, commentNames) +
           (overrides && style.saysOverride ? " override" : "");
}

}  // namespace

std::string indentUnit(const std::string& text, const model::UserClass& type) {
    const std::string outer = indentAt(text, type.whole.begin);
    for (const UserFunction& function : type.functions) {
        if (!function.inClass || !isFirstInLine(text, function.whole.begin)) continue;
        const std::string indent = indentAt(text, function.whole.begin);
        if (indent.size() > outer.size() && indent.compare(0, outer.size(), outer) == 0)
            return indent.substr(outer.size());
    }
    return "    ";
}

namespace {

/// Returns the indentation of the first line of a body; nothing if no suitable function has a body with lines.
template <class Test>
std::string bodyUnit(const std::string& text, const model::UserClass& type, const UserFunction* near, Test test) {
    const auto hasLines = [&](const UserFunction& function) {
        if (!test(function) || function.body.empty()) return false;
        const std::size_t line = text.find('\n', function.body.begin);
        if (line == std::string::npos || line >= function.body.end) return false;
        const std::size_t word = text.find_first_not_of(" \t\r\n", line);
        return word < function.body.end - 1 && text[word] != '#' &&
               indentAt(text, word).size() > indentAt(text, function.whole.begin).size();
    };
    const UserFunction* sample = sampleOf(type, near, hasLines);
    if (sample == nullptr) return {};
    const std::size_t line = text.find('\n', sample->body.begin);
    const std::string inner = indentAt(text, text.find_first_not_of(" \t\r\n", line));
    return inner.substr(indentAt(text, sample->whole.begin).size());
}

}  // namespace

MethodStyle declarationStyle(const std::string& text, const model::UserClass& type, const UserFunction* near) {
    MethodStyle style;
    style.lineEnd = lineEndOf(text);
    style.unit = indentUnit(text, type);
    const bool hasLine = near != nullptr && isFirstInLine(text, near->whole.begin);
    style.indent = indentAt(text, hasLine ? near->whole.begin : type.whole.begin) + (hasLine ? "" : style.unit);
    const auto here = [&](const UserFunction& function) { return function.file == type.file && function.inClass; };
    const std::string unit = bodyUnit(text, type, near, here);
    if (!unit.empty()) style.unit = unit;
    style.docMark = docMark(text, type);
    const auto plain = [](const UserFunction& function) { return function.inClass && isPlain(function); };
    if (const UserFunction* sample = sampleOf(type, near, plain)) takeSpaces(text, *sample, style);
    const auto tells = [](const UserFunction& function) {
        return function.inClass && function.kind == FunctionKind::Method && isSample(function) &&
               (function.saysVirtual || function.saysOverride);
    };
    if (const UserFunction* sample = sampleOf(type, near, tells)) {
        style.saysVirtual = sample->saysVirtual;
        style.saysOverride = sample->saysOverride;
    }
    takeBrace(text, type, type.file, style);
    if (near != nullptr) {
        const std::size_t start = withComment(text, near->whole.begin);
        style.blankLine = near->kind != FunctionKind::Method || blankAbove(text, start);
    }
    return style;
}

MethodStyle definitionStyle(const std::string& text, const model::UserClass& type, const std::string& file,
                            const UserFunction* near) {
    MethodStyle style;
    style.lineEnd = lineEndOf(text);
    if (near != nullptr) style.indent = indentAt(text, near->whole.begin);
    const auto plain = [&](const UserFunction& function) {
        return function.file == file && !function.inClass && isPlain(function);
    };
    if (const UserFunction* sample = sampleOf(type, near, plain)) takeSpaces(text, *sample, style);
    takeBrace(text, type, file, style);
    const auto here = [&](const UserFunction& function) { return function.file == file && !function.inClass; };
    const std::string unit = bodyUnit(text, type, near, here);
    if (!unit.empty()) {
        style.unit = unit;
    } else if (type.file == file) {
        style.unit = indentUnit(text, type);
    }
    return style;
}

std::string inBlockComment(std::string line) {
    for (std::size_t at = line.find("*/"); at != std::string::npos; at = line.find("*/", at + 3))
        line.insert(at + 1, " ");
    return line;
}

std::vector<std::string> commentText(const MethodStyle& style, const std::vector<std::string>& lines) {
    std::vector<std::string> result;
    if (lines.empty()) return result;
    if (style.docMark != "/**") {
        for (const std::string& line : lines) result.push_back(style.docMark + (line.empty() ? "" : " " + line));
        return result;
    }
    if (lines.size() == 1) return {"/** " + inBlockComment(lines.front()) + " */"};
    result.push_back("/**");
    for (const std::string& line : lines) result.push_back(" *" + (line.empty() ? "" : " " + inBlockComment(line)));
    result.push_back(" */");
    return result;
}

std::string declarationText(const MethodStyle& style, const WantedMethod& method, bool overrides) {
    return declared(style, method, overrides, false) + ";" + style.lineEnd;
}

std::string inlineText(const MethodStyle& style, const WantedMethod& method, bool overrides) {
    return declared(style, method, overrides, true) + bodyText(style, method);
}

std::string definitionText(const MethodStyle& style, const WantedMethod& method, const std::string& qualifier,
                           bool trailingReturn) {
    const std::string type = trailingReturn ? "auto " : method.signature.returns + style.behindReturn;
    return style.indent + type + qualifier + method.name + style.beforeBracket + arguments(style, method, true) +
           (trailingReturn ? " -> " + method.signature.returns : "") + bodyText(style, method);
}

bool needsNamespace(const std::string& type, const std::string& home) {
    if (home.empty()) return false;
    const std::string first = model::splitQualified(home).front();
    std::string word;
    std::string before;
    for (std::size_t at = 0; at <= type.size(); ++at) {
        const char c = at < type.size() ? type[at] : ' ';
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
            word += c;
            continue;
        }
        const bool own = !word.empty() && !model::isKeyword(word) && word != "std" && word != first &&
                         std::isdigit(static_cast<unsigned char>(word[0])) == 0;
        if (own && before != "::" && model::classify(word) == model::TypeClass::Other) return true;
        if (!word.empty()) before.clear();
        if (c == ':') {
            before += c;
        } else if (c != ' ') {
            before.clear();
        }
        word.clear();
    }
    return false;
}

}  // namespace oroforge::merge
