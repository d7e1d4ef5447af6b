// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/plan_methods.hpp>

#include <algorithm>

#include <merge/change_method.hpp>
#include <merge/new_methods.hpp>
#include <merge/text_places.hpp>
#include <model/cpp_type.hpp>

namespace oroforge::merge {

namespace {

using model::UserFunction;

class Planner {
public:
    Planner(const WantedClass& wanted, const model::UserClass& type, const Input& input, Plan& into, diag::Sink& sink)
        : wanted_(wanted), type_(type), input_(input), into_(into), sink_(sink), fresh_(wanted, type, input, into) {
        const auto found = input.record.find(wanted.name);
        if (found != input.record.end()) recorded_ = found->second;
    }

    void run() {
        for (const WantedMethod& method : wanted_.methods) plan(method);
    }

private:
    std::vector<const UserFunction*> declared(const std::string& name) const {
        std::vector<const UserFunction*> all;
        for (const UserFunction& function : type_.functions)
            if (function.inClass && function.name == name) all.push_back(&function);
        return all;
    }

    const UserFunction* withSignature(const std::vector<const UserFunction*>& among, const model::Signature& wanted) {
        for (const UserFunction* one : among)
            if (hasSignature(*one, wanted, wanted_.name, input_)) return one;
        return nullptr;
    }

    bool sameSignature(const model::Signature& a, const model::Signature& b) const {
        const auto answers = input_.answers.find(wanted_.name);
        if (answers != input_.answers.end()) {
            const auto first = answers->second.find(question(a)), second = answers->second.find(question(b));
            const auto end = answers->second.end();
            if (first != end && second != end && first->second.known() && second->second.known())
                return first->second == second->second;
        }
        return model::normalised(question(a)) == model::normalised(question(b));
    }

    void keepRecord(const WantedMethod& method, bool kept) {
        into_.record[wanted_.name].methods[method.name] = {method.signature, method.isHook, kept};
    }

    bool chosen(const std::set<std::string>& names, const WantedMethod& method) const {
        return isChosen(names, wanted_.name, method.shown);
    }

    void plan(const WantedMethod& method) {
        const std::vector<const UserFunction*> present = declared(method.name);
        const auto found = recorded_.methods.find(method.name);
        const RecordedMethod* last = found == recorded_.methods.end() ? nullptr : &found->second;
        if (withSignature(present, method.signature) != nullptr) return keepRecord(method, false);
        const bool unchanged = last != nullptr && sameSignature(last->signature, method.signature);
        const bool takeManifest = chosen(input_.choices.manifest, method);
        if (chosen(input_.choices.code, method) || (unchanged && last->kept && !takeManifest))
            return keepRecord(method, true);
        if (present.empty()) return planAbsent(method, last, unchanged, takeManifest);
        const UserFunction* old = last != nullptr ? withSignature(present, last->signature) : nullptr;
        if (old != nullptr && !unchanged) return change(*old, last->signature, method);
        if (takeManifest && present.size() == 1) return change(*present.front(), signatureOf(*present.front()), method);
        conflict(*present.front(), method, last, unchanged, present.size());
    }

    void planAbsent(const WantedMethod& method, const RecordedMethod* last, bool unchanged, bool takeManifest) {
        if (last != nullptr && unchanged && !takeManifest) {
            // The user removed it. If it is not wanted back, the manifest must drop it.
            keepRecord(method, false);
            return warnRemoved(type_, kind(method), method.shown, method.where, sink_);
        }
        if (type_.isMacro) {
            sink_
                .error(type_.where, "OC032",
                       "a macro makes class '" + type_.name + "': " + kind(method) + " '" + method.shown +
                           "' cannot be added to it")
                .note(method.where, "wanted here");
            return;
        }
        if (skippedLinesMention(input_.code, type_.file, type_.body, method.name)) {
            sink_
                .error(type_.where, "OC033",
                       "lines of class '" + type_.name + "' that the compiler skips, between #if and #endif, name '" +
                           method.name + "': whether that is " + kind(method) + " '" + method.shown + "' is unknown")
                .note(method.where, "wanted here")
                .hint("declare it by hand where it is missing, or leave it so with '--take-code " + method.shown + "'");
            return;
        }
        fresh_.add(method);
        keepRecord(method, false);
    }

    void change(const UserFunction& function, const model::Signature& from, const WantedMethod& method) {
        if (changeMethod(function, from, method, type_, input_, into_, sink_)) keepRecord(method, false);
    }

    model::Signature signatureOf(const UserFunction& function) const {
        const std::string& text = input_.code.texts.at(function.file);
        model::Signature signature;
        signature.returns = cut(text, function.returns);
        for (const model::UserParameter& one : function.parameters) {
            const std::string words = cut(text, one.whole);
            const std::string type = one.type.empty() ? words : cut(text, one.type);
            signature.arguments.push_back({withoutLayout(type), one.name});
        }
        return signature;
    }

    static std::string kind(const WantedMethod& method) { return method.isHook ? "hook" : "operation"; }

    void conflict(const UserFunction& function, const WantedMethod& method, const RecordedMethod* last, bool unchanged,
                  std::size_t count) {
        const std::string wanted = toText(method.signature, method.name);
        const std::string written = asWritten(function, input_.code);
        std::string why = "there is no record of how it was last written";
        if (last != nullptr) {
            why = unchanged ? "it was changed here" : "it was changed both here and there";
            why += "; it was once '" + toText(last->signature, method.name) + "'";
        }
        auto& error = sink_.error(function.where, "OC031",
                                  kind(method) + " '" + method.shown + "' is '" + written + "' here and '" + wanted +
                                      "' in the manifest: " + why);
        error.note(method.where, "in the manifest here");
        if (count == 1) {
            error.hint("'--take-manifest " + method.shown + "' changes the code, '--take-code " + method.shown +
                       "' leaves it as it is");
        } else {
            error.hint("there are " + std::to_string(count) +
                       " of that name: change the right one by hand, or leave them" +
                       " as they are with '--take-code " + method.shown + "'");
        }
    }

    const WantedClass& wanted_;
    const model::UserClass& type_;
    const Input& input_;
    Plan& into_;
    diag::Sink& sink_;
    RecordedClass recorded_;
    NewMethods fresh_;
};

}  // namespace

bool hasSignature(const UserFunction& function, const model::Signature& signature, const std::string& className,
                  const Input& input) {
    if (function.isTemplate || function.isOther || function.kind != model::FunctionKind::Method) return false;
    const auto answers = input.answers.find(className);
    if (answers != input.answers.end()) {
        const auto answer = answers->second.find(question(signature));
        if (answer != answers->second.end() && answer->second.known() && function.types.known())
            return answer->second == function.types;
    }
    if (function.isMacro || function.parameters.size() != signature.arguments.size()) return false;
    const std::string& text = input.code.texts.at(function.file);
    if (withoutLayout(cut(text, function.returns)) != model::normalised(signature.returns)) return false;
    for (std::size_t i = 0; i != function.parameters.size(); ++i) {
        const model::Span type = function.parameters[i].type;
        if (withoutLayout(cut(text, type)) != model::normalised(signature.arguments[i].type)) return false;
    }
    return true;
}

std::string asWritten(const UserFunction& function, const model::UserCode& code) {
    const std::string& text = code.texts.at(function.file);
    if (function.isMacro) return function.name + "(…)";
    std::string arguments = withoutLayout(cut(text, function.brackets));
    for (std::size_t at = arguments.find(','); at != std::string::npos; at = arguments.find(',', at + 1))
        arguments.insert(at + 1, " ");
    const bool trailing = function.returns.begin > function.brackets.end;
    const std::string type = withoutLayout(cut(text, function.returns));
    return (function.isTemplate ? "template " : "") + (trailing ? "auto" : type) + " " + function.name + "(" +
           arguments + ")" + (function.isOther ? " …" : "") + (trailing ? " -> " + type : "");
}

void warnRemoved(const model::UserClass& type, const std::string& kind, const std::string& shown,
                 const diag::Location& where, diag::Sink& sink) {
    sink.warning(type.where, "OC034",
                 "class '" + type.name + "' no longer has " + kind + " '" + shown + "', which the manifest still has")
        .note(where, "in the manifest here")
        .hint("'--take-manifest " + shown + "' writes it again, '--take-code " + shown + "' leaves it out");
}

void planMethods(const WantedClass& wanted, const model::UserClass& type, const Input& input, Plan& into,
                 diag::Sink& sink) {
    into.record[wanted.name];
    Planner(wanted, type, input, into, sink).run();
}

}  // namespace oroforge::merge
