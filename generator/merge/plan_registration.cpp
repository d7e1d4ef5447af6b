// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/plan_registration.hpp>

#include <algorithm>

#include <merge/text_places.hpp>
#include <model/literal.hpp>

namespace oroforge::merge {

namespace {

using model::UserText;

enum class Verdict { Leave, Change, Conflict };

/// Compares the words in the code with the last written and the wanted ones.
Verdict verdict(const std::string& code, const std::string* last, const std::string& wanted, bool takeManifest) {
    if (code == wanted) return Verdict::Leave;
    if (takeManifest) return Verdict::Change;
    // The writer is unknown, or only the user changed it.
    if (last == nullptr || *last == wanted) return Verdict::Leave;
    return code == *last ? Verdict::Change : Verdict::Conflict;
}

template <class Texts>
auto textOf(const Texts& texts, const std::string& argument) -> decltype(&texts.front()) {
    for (const auto& text : texts)
        if (text.argument == argument) return &text;
    return nullptr;
}

/// Joins the names of arguments into a text that can be compared.
template <class Texts>
std::string namesIn(const Texts& texts) {
    std::string names;
    for (const auto& text : texts)
        if (!text.argument.empty()) names += (names.empty() ? "" : ", ") + text.argument;
    return names;
}

class Planner {
public:
    Planner(const Registration& wanted, const Registration* last, const model::UserRegistration& call,
            const Registered& names, const Input& input, Plan& into, diag::Sink& sink)
        : wanted_(wanted),
          last_(last),
          call_(call),
          names_(names),
          text_(input.code.texts.at(call.file)),
          into_(into),
          sink_(sink) {}

    bool run() {
        planHow();
        if (!call_.textsKnown) {
            if (last_ != nullptr && wanted_.texts != last_->texts)
                refuse("what is described behind it is not written plainly");
            return fine_;
        }
        planDoc();
        planArguments();
        return fine_;
    }

private:
    void refuse(const std::string& why) {
        fine_ = false;
        sink_
            .error(call_.where, "OC032",
                   "the call that registers " + names_.what + " cannot follow the manifest: " + why)
            .note(names_.where, "in the manifest here")
            .hint("change it by hand, then say that all is as it should be with '--take-code " + names_.shown + "'");
    }

    void conflict(const std::string& part, const std::string& code, const std::string& last,
                  const std::string& wanted) {
        fine_ = false;
        sink_
            .error(call_.where, "OC031",
                   part + " of " + names_.what + " is '" + code + "' here and '" + wanted +
                       "' in the manifest; it was once '" + last + "'")
            .note(names_.where, "in the manifest here")
            .hint("'--take-manifest " + names_.shown + "' changes the code, '--take-code " + names_.shown +
                  "' leaves it as it is");
    }

    void replace(model::Span span, const std::string& with) {
        into_.edits.replace(call_.file, span, with);
        if (!told_) into_.changes.push_back(call_.file + ": " + names_.what + " is registered anew");
        told_ = true;
    }

    void planHow() {
        const std::string* last = last_ == nullptr ? nullptr : &last_->how;
        const bool operation = call_.verb == "addOperation";
        const std::string code = !operation ? call_.verb : call_.thread.empty() ? "ClientThread" : call_.thread;
        const Verdict found = verdict(code, last, wanted_.how, names_.takeManifest);
        if (found == Verdict::Conflict)
            return conflict(operation ? "the thread" : "the call", code, *last, wanted_.how);
        if (found == Verdict::Leave) return;
        if (!operation) return replace(call_.verbSpan, wanted_.how);
        if (!call_.threadSpan.empty()) return replace(call_.threadSpan, wanted_.how);
        if (call_.arguments != 3) return refuse("no place for " + wanted_.how + " was found");
        replace({call_.callEnd - 1, call_.callEnd - 1}, ", RTT::" + wanted_.how);
    }

    /// True if the words of a doc() or arg() must be replaced.
    bool changes(const UserText& code, const DocText& wanted) {
        const auto* last = last_ == nullptr ? nullptr : textOf(last_->texts, wanted.argument);
        const std::string part =
            wanted.argument.empty() ? "the text" : "the text of argument '" + wanted.argument + "'";
        const Verdict found =
            verdict(code.words, last == nullptr ? nullptr : &last->words, wanted.words, names_.takeManifest);
        if (found == Verdict::Conflict) conflict(part, code.words, last->words, wanted.words);
        if (found != Verdict::Change) return false;
        if (code.literal.empty()) refuse(part + " is not written plainly");
        return !code.literal.empty();
    }

    void planWords(const UserText& code, const DocText& wanted) {
        if (changes(code, wanted)) replace(code.literal, model::stringLiteral(wanted.words));
    }

    void planDoc() {
        const DocText* wanted = textOf(wanted_.texts, "");
        if (wanted == nullptr) return;
        if (const UserText* code = textOf(call_.texts, "")) return planWords(*code, *wanted);
        // A text that was recorded but is missing was removed by the user.
        const bool isNew = last_ != nullptr && textOf(last_->texts, "") == nullptr;
        if (!isNew && !names_.takeManifest) return;
        replace({call_.callEnd, call_.callEnd}, gap() + ".doc(" + model::stringLiteral(wanted->words) + ")");
    }

    /// Returns what the user puts before ".doc" or ".arg": nothing, or a new line.
    std::string gap() const {
        if (call_.texts.empty()) return {};
        const std::string found = cut(text_, {call_.callEnd, call_.texts.front().call.begin});
        return isBlank(found) ? found : std::string();
    }

    void planArguments() {
        const std::string code = namesIn(call_.texts), wanted = namesIn(wanted_.texts);
        if (code == wanted) {
            for (const DocText& one : wanted_.texts)
                if (!one.argument.empty()) planWords(*textOf(call_.texts, one.argument), one);
            return;
        }
        const std::string last = last_ == nullptr ? "" : namesIn(last_->texts);
        if (code.empty() && !last.empty() && !names_.takeManifest) return;
        const Verdict found = verdict(code, last_ == nullptr ? nullptr : &last, wanted, names_.takeManifest);
        if (found == Verdict::Conflict) return conflict("the list of arguments", code, last, wanted);
        if (found == Verdict::Change) rewriteArguments();
    }

    void rewriteArguments() {
        const auto first = std::find_if(call_.texts.begin(), call_.texts.end(),
                                        [](const UserText& one) { return !one.argument.empty(); });
        if (std::any_of(first, call_.texts.end(), [](const UserText& one) { return one.argument.empty(); }))
            return refuse("doc() follows arg()");
        std::size_t at = first == call_.texts.begin() ? call_.callEnd : std::prev(first)->call.end;
        const model::Span all{at, call_.texts.empty() ? at : call_.texts.back().call.end};
        std::map<std::string, model::Span> pieces;
        for (auto one = first; one != call_.texts.end(); ++one) {
            pieces[one->argument] = {at, one->call.end};
            at = one->call.end;
            if (textOf(wanted_.texts, one->argument) == nullptr && hasComment(cut(text_, pieces[one->argument])))
                return refuse("there is a comment beside argument '" + one->argument +
                              "', which the manifest no longer has");
        }
        std::string result;
        for (const DocText& one : wanted_.texts) {
            if (one.argument.empty()) continue;
            const auto piece = pieces.find(one.argument);
            if (piece == pieces.end()) {
                result += gap() + ".arg(\"" + one.argument + "\", " + model::stringLiteral(one.words) + ")";
                continue;
            }
            const UserText& code = *textOf(call_.texts, one.argument);
            const bool anew = changes(code, one);
            const model::Span words = anew ? code.literal : model::Span{code.call.end, code.call.end};
            result += cut(text_, {piece->second.begin, words.begin}) + (anew ? model::stringLiteral(one.words) : "") +
                      cut(text_, {words.end, piece->second.end});
        }
        replace(all, result);
    }

    const Registration& wanted_;
    const Registration* last_;
    const model::UserRegistration& call_;
    const Registered& names_;
    const std::string& text_;
    Plan& into_;
    diag::Sink& sink_;
    bool fine_ = true;
    bool told_ = false;
};

}  // namespace

bool planRegistration(const Registration& wanted, const Registration* last, const model::UserRegistration& call,
                      const Registered& names, const Input& input, Plan& into, diag::Sink& sink) {
    return Planner(wanted, last, call, names, input, into, sink).run();
}

}  // namespace oroforge::merge
