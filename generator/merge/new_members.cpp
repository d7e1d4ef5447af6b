// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/new_members.hpp>

#include <algorithm>

#include <merge/method_style.hpp>
#include <merge/text_places.hpp>
#include <model/literal.hpp>
#include <model/names.hpp>

namespace oroforge::merge {

namespace {

using model::UserField;
using model::UserRegistration;

/// Finds the last call of the kind that runs unconditionally.
const UserRegistration* lastCall(const model::UserClass& type, const std::string& kind, const std::string& file) {
    const UserRegistration* last = nullptr;
    for (const UserRegistration& one : type.registrations) {
        if (one.isNested || one.file != file || (!kind.empty() && !registers(one.verb, kind))) continue;
        if (last == nullptr || last->statement < one.statement) last = &one;
    }
    return last;
}

std::size_t behindLastLine(const std::string& text, const model::UserFunction& constructor) {
    const std::size_t close = constructor.body.end - 1;
    return isFirstInLine(text, close) ? lineBegin(text, close) : close;
}

}  // namespace

bool registers(const std::string& verb, const std::string& kind) {
    if (kind == "port") return verb == "addPort" || verb == "addEventPort" || verb == "addLocalPort";
    if (kind == "property") return verb == "addProperty";
    if (kind == "attribute") return verb == "addAttribute" || verb == "addConstant";
    return verb == "addOperation";
}

NewMembers::NewMembers(const model::UserClass& type, const Input& input, Plan& into)
    : type_(type), input_(input), into_(into) {
    const UserRegistration* any = nullptr;
    for (const UserRegistration& one : type.registrations)
        if (any == nullptr) any = &one;
    for (const model::UserFunction& function : type.functions) {
        if (function.kind != model::FunctionKind::Constructor || function.body.empty() || function.isMacro) continue;
        const bool registersThere = any != nullptr && any->file == function.file && function.body.holds(any->statement);
        if (constructor_ == nullptr || registersThere) constructor_ = &function;
    }
}

const UserField* NewMembers::lastField(const std::string& kind) const {
    const UserField* last = nullptr;
    const auto take = [&](const UserField& field) {
        const bool usable = field.file == type_.file && field.whole.end > field.whole.begin;
        if (usable && (last == nullptr || last->whole < field.whole)) last = &field;
    };
    for (const UserField& field : type_.fields) {
        if (kind == "port") {
            if (!field.portClass.empty() && field.portClass.find("Port") != std::string::npos) take(field);
            continue;
        }
        for (const UserRegistration& one : type_.registrations)
            if (one.member == field.name && registers(one.verb, kind)) take(field);
    }
    return last;
}

std::string NewMembers::memberName(const WantedMember& member) const {
    // Follows the name of the last member of its kind, or of any other kind: level_, m_level, _level or level.
    for (const std::string& kind :
         {member.kind, std::string("port"), std::string("property"), std::string("attribute")}) {
        for (auto one = type_.registrations.rbegin(); one != type_.registrations.rend(); ++one) {
            if (!registers(one->verb, kind) || one->literal.empty() || one->member.empty()) continue;
            const std::size_t at = one->member.find(one->literal);
            if (at != std::string::npos)
                return one->member.substr(0, at) + member.method + one->member.substr(at + one->literal.size());
        }
    }
    return model::memberName(member.method);
}

/// Returns "RTT::", or nothing if the class writes "InputPort<double>".
std::string NewMembers::portPrefix() const {
    const UserField* last = lastField("port");
    if (last == nullptr) return "RTT::";
    const std::string words = cut(input_.code.texts.at(last->file), last->whole);
    const std::size_t at = words.find(last->portClass);
    return at != std::string::npos && words.compare(at > 5 ? at - 5 : 0, 5, "RTT::") != 0 ? "" : "RTT::";
}

std::string NewMembers::declare(const WantedMember& member) {
    std::string name = memberName(member);
    const auto isTaken = [&](const UserField& field) { return field.name == name; };
    while (std::any_of(type_.fields.begin(), type_.fields.end(), isTaken)) name += '_';
    const std::string& text = input_.code.texts.at(type_.file);
    const std::string lineEnd = lineEndOf(text);
    const std::string type =
        member.portClass.empty() ? member.declared : portPrefix() + member.portClass + "<" + member.type + ">";
    const UserField* last = lastField(member.kind);
    if (last == nullptr && member.kind == "attribute") last = lastField("property");
    if (last == nullptr) {
        for (const UserField& field : type_.fields)
            if (field.file == type_.file && field.whole.end > field.whole.begin &&
                (last == nullptr || last->whole < field.whole))
                last = &field;
    }
    const Place place =
        last == nullptr ? Place{} : placeBehind({{last->file, last->whole, type_.body, nullptr}}, type_, input_.code);
    // Code after it in the same line must not become a part of its comment.
    const bool inLine = place.known && place.at < text.size() && place.at > 0 && text[place.at - 1] != '\n';
    const std::string comment = member.comment.empty() ? ""
                                : inLine               ? "  /**< " + inBlockComment(member.comment) + " */"
                                                       : "  ///< " + member.comment;
    const std::string line = type + " " + name + member.initialiser + ";" + comment + lineEnd;
    if (place.known) {
        declarations_[place.at] += indentAt(text, last->whole.begin) + line;
    } else {
        const bool alone = isFirstInLine(text, type_.body.end);
        std::string& lines = declarations_[alone ? lineBegin(text, type_.body.end) : type_.body.end];
        const std::string outer = indentAt(text, type_.whole.begin);
        if (!atEnd_) lines += (isBlank(cut(text, type_.body)) ? "" : lineEnd) + outer + "private:" + lineEnd;
        atEnd_ = true;
        lines += outer + indentUnit(text, type_) + line;
    }
    into_.changes.push_back(type_.file + ": " + type + " " + name);
    return name;
}

std::string NewMembers::receiverLike(const UserRegistration* sample, bool sameKind) const {
    if (sample == nullptr) return "this->";
    const std::string receiver = cut(input_.code.texts.at(sample->file), sample->receiver);
    if (receiver.empty() || receiver == "this->") return receiver;
    const bool simple = receiver.find_first_of("\"\n/") == std::string::npos;
    if (sameKind && simple) return receiver;
    return receiver.compare(0, 6, "this->") == 0 ? "this->" : "";
}

void NewMembers::registerBy(const std::string& kind, const std::string& path, const std::string& bare,
                            const std::vector<DocText>& texts) {
    std::string call = bare;
    for (const DocText& one : texts)
        call += one.argument.empty() ? ".doc(" + model::stringLiteral(one.words) + ")"
                                     : ".arg(\"" + one.argument + "\", " + model::stringLiteral(one.words) + ")";
    const std::string& text = input_.code.texts.at(constructor_->file);
    const UserRegistration* sample = lastCall(type_, kind, constructor_->file);
    const bool sameKind = sample != nullptr;
    if (!sameKind) sample = lastCall(type_, "", constructor_->file);
    if (sample != nullptr && !constructor_->body.holds(sample->statement)) sample = nullptr;
    const std::string lineEnd = lineEndOf(text);
    std::string receiver = receiverLike(sample, sameKind && path.empty());
    const std::string words = receiver + path + call + ";" + lineEnd;
    Place place;
    if (sample != nullptr)
        place = placeBehind({{sample->file, sample->statement, constructor_->body, nullptr}}, type_, input_.code);
    if (place.known) {
        calls_[place.at] += indentAt(text, sample->statement.begin) + words;
    } else {
        const MethodStyle style = definitionStyle(text, type_, constructor_->file, constructor_);
        calls_[behindLastLine(text, *constructor_)] += indentAt(text, constructor_->whole.begin) + style.unit + words;
    }
    into_.changes.push_back(constructor_->file + ": " + receiver + path + call);
}

void NewMembers::finish() {
    for (const auto& [at, lines] : declarations_) {
        const std::string& text = input_.code.texts.at(type_.file);
        const bool atBrace = at == type_.body.end && !isFirstInLine(text, at);
        insertLines(into_.edits, text, type_.file, at, lines + (atBrace ? lineEndOf(text) : ""), lineEndOf(text),
                    false);
    }
    for (const auto& [at, lines] : calls_) {
        const std::string& text = input_.code.texts.at(constructor_->file);
        const std::string lineEnd = lineEndOf(text);
        // "{}" and "{ run(); }" are broken into lines.
        const bool atBrace = at == constructor_->body.end - 1 && !isFirstInLine(text, at);
        const std::string outer = indentAt(text, constructor_->whole.begin);
        if (atBrace) {
            into_.edits.insert(constructor_->file, at, lineEnd + lines + outer);
        } else {
            insertLines(into_.edits, text, constructor_->file, at, lines, lineEnd, false);
        }
    }
}

}  // namespace oroforge::merge
