// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/change_method.hpp>

#include <algorithm>

#include <merge/argument_list.hpp>
#include <merge/insertion.hpp>
#include <merge/method_style.hpp>
#include <merge/plan_methods.hpp>
#include <merge/text_places.hpp>
#include <model/cpp_type.hpp>
#include <model/names.hpp>

namespace oroforge::merge {

namespace {

using model::UserFunction;

class Changer {
public:
    Changer(const model::Signature& from, const WantedMethod& method, const model::UserClass& type, const Input& input,
            diag::Sink& sink)
        : from_(from), method_(method), type_(type), input_(input), sink_(sink) {}

    void change(const UserFunction& function) {
        if (function.isMacro) return refuse(function, "a macro makes it");
        const std::string& text = input_.code.texts.at(function.file);
        if (model::normalised(from_.returns) != model::normalised(method_.signature.returns)) {
            const std::string old = cut(text, function.returns);
            if (function.returns.empty() || hasComment(old)) return refuse(function, "its type is not written plainly");
            const std::string home = model::namespaceOf(type_.name);
            const bool outside =
                !function.inClass && function.space != home && function.returns.begin < function.nameSpan.begin;
            if (outside && needsNamespace(method_.signature.returns, home))
                return refuse(function, "it is outside of namespace '" + home + "', where '" +
                                            method_.signature.returns + "' may mean something else");
            replace(function.file, text, function.returns, method_.signature.returns);
        }
        const NewArguments list =
            changedArguments(text, function, from_.arguments, method_.signature.arguments, function.isDefinition);
        if (!list.fault.empty()) return refuse(function, list.fault);
        replace(function.file, text, function.brackets, list.text);
        changed.push_back(function.file + ": " + toText(method_.signature, method_.name));
    }

    struct Replacement {
        std::string file;
        Edit edit;
    };
    std::vector<Replacement> replacements;
    std::vector<std::string> changed;
    bool refused = false;

private:
    void refuse(const UserFunction& function, const std::string& why) {
        refused = true;
        sink_
            .error(function.where, "OC032",
                   "'" + asWritten(function, input_.code) + "' cannot become '" +
                       toText(method_.signature, method_.name) + "', as the manifest wants it: " + why)
            .note(method_.where, "in the manifest here")
            .hint("change it by hand; then there is nothing left to do");
    }

    /// Leaves out equal text at both ends, so that the edit is small.
    void replace(const std::string& file, const std::string& text, model::Span span, std::string with) {
        std::size_t front = 0;
        while (front < with.size() && span.begin < span.end && text[span.begin] == with[front]) {
            ++front;
            ++span.begin;
        }
        with.erase(0, front);
        while (!with.empty() && span.begin < span.end && text[span.end - 1] == with.back()) {
            --span.end;
            with.pop_back();
        }
        if (!span.empty() || !with.empty()) replacements.push_back({file, {span, with}});
    }

    const model::Signature& from_;
    const WantedMethod& method_;
    const model::UserClass& type_;
    const Input& input_;
    diag::Sink& sink_;
};

/// Returns the definitions outside the class that have the same types.
std::vector<const UserFunction*> definitionsOf(const UserFunction& declaration, const model::UserClass& type) {
    std::vector<const UserFunction*> same, all;
    for (const UserFunction& function : type.functions) {
        if (function.inClass || function.name != declaration.name) continue;
        all.push_back(&function);
        if (function.types.known() && function.types == declaration.types) same.push_back(&function);
    }
    if (!same.empty() || all.size() != 1) return same;
    return all.front()->parameters.size() == declaration.parameters.size() ? all : same;
}

/// True if lines that the compiler skips contain "Plant::finish".
bool definedInSkippedLines(const model::UserCode& code, const model::UserClass& type, const std::string& method) {
    const std::string name = type.name.substr(type.name.rfind(':') == std::string::npos ? 0 : type.name.rfind(':') + 1);
    for (const auto& [file, conditionals] : code.conditionals) {
        const auto text = code.texts.find(file);
        if (text == code.texts.end()) continue;
        for (const model::Span& lines : conditionals.skipped)
            if (mentions(withoutLayout(cut(text->second, lines)), name + "::" + method)) return true;
    }
    return false;
}

}  // namespace

bool changeMethod(const UserFunction& declaration, const model::Signature& from, const WantedMethod& method,
                  const model::UserClass& type, const Input& input, Plan& into, diag::Sink& sink) {
    if (skippedLinesMention(input.code, declaration.file, type.body, method.name) ||
        definedInSkippedLines(input.code, type, method.name)) {
        sink.error(declaration.where, "OC033",
                   "'" + method.name +
                       "' is also named in lines that the compiler skips, between #if and #endif: what is " +
                       "to become of those is unknown")
            .note(method.where, "the manifest wants '" + toText(method.signature, method.name) + "'")
            .hint("change it by hand in all branches; then there is nothing left to do");
        return false;
    }
    Changer changer(from, method, type, input, sink);
    changer.change(declaration);
    for (const UserFunction* definition : definitionsOf(declaration, type)) changer.change(*definition);
    if (changer.refused) return false;
    for (const Changer::Replacement& one : changer.replacements)
        into.edits.replace(one.file, one.edit.span, one.edit.text);
    into.changes.insert(into.changes.end(), changer.changed.begin(), changer.changed.end());
    return true;
}

}  // namespace oroforge::merge
