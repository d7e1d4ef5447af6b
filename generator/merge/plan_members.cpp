// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Classes without a generated base declare and register ports, properties, attributes and operations themselves.
#include <algorithm>

#include <merge/new_members.hpp>
#include <merge/plan.hpp>
#include <merge/plan_methods.hpp>
#include <merge/plan_registration.hpp>
#include <merge/text_places.hpp>
#include <model/cpp_type.hpp>

namespace oroforge::merge {

namespace {

using model::UserField;
using model::UserRegistration;

class MemberPlanner {
public:
    MemberPlanner(const WantedClass& wanted, const model::UserClass& type, const Input& input, Plan& into,
                  diag::Sink& sink)
        : wanted_(wanted), type_(type), input_(input), into_(into), sink_(sink), fresh_(type, input, into) {
        const auto found = input.record.find(wanted.name);
        if (found != input.record.end()) recorded_ = found->second;
    }

    void run() {
        for (const WantedMember& member : wanted_.members) plan(member);
        for (const WantedMethod& method : wanted_.methods)
            if (!method.isHook) planOperation(method);
        fresh_.finish();
    }

private:
    const UserField* fieldNamed(const std::string& name) const {
        for (const UserField& field : type_.fields)
            if (field.name == name) return &field;
        return nullptr;
    }

    /// Finds a field that no call registers as something else.
    const UserField* freeField(const std::string& name) const {
        const bool taken = std::any_of(type_.registrations.begin(), type_.registrations.end(),
                                       [&](const UserRegistration& one) { return one.member == name; });
        return taken ? nullptr : fieldNamed(name);
    }

    /// Finds the call that registers "gripper.force": its text, or the initialiser of its data member, has the name.
    const UserRegistration* callFor(const std::string& kind, const std::string& name, const std::string& shown) const {
        const std::string service = shown.size() > name.size() ? shown.substr(0, shown.size() - name.size() - 1) : "";
        const UserRegistration* ofAnyService = nullptr;
        for (const UserRegistration& one : type_.registrations) {
            if (!registers(one.verb, kind)) continue;
            const UserField* field = fieldNamed(one.member);
            const std::string known = !one.literal.empty() ? one.literal : field != nullptr ? field->literal : "";
            if (known != name) continue;
            if (one.knowsService && one.service == service) return &one;
            if (!one.knowsService) ofAnyService = &one;
        }
        return ofAnyService;
    }

    /// Finds a call of that kind whose name is not known.
    const UserRegistration* unclear(const std::string& kind) const {
        for (const UserRegistration& one : type_.registrations) {
            if (!registers(one.verb, kind) || !one.literal.empty()) continue;
            const UserField* field = fieldNamed(one.member);
            if (field == nullptr || field->literal.empty()) return &one;
        }
        return nullptr;
    }

    bool chosen(const std::set<std::string>& names, const std::string& shown) const {
        return isChosen(names, wanted_.name, shown);
    }

    bool hasType(const UserField& field, const std::string& type) const {
        const auto answers = input_.answers.find(wanted_.name);
        if (answers != input_.answers.end()) {
            const auto answer = answers->second.find(question({"void", {{type, ""}}}));
            if (answer != answers->second.end() && answer->second.known() && !field.canonical.empty())
                return answer->second.arguments.front() == field.canonical;
        }
        return withoutLayout(cut(input_.code.texts.at(field.file), field.type)) == model::normalised(type);
    }

    void keepRecord(const WantedMember& member, const std::string& name, bool kept) {
        into_.record[wanted_.name].members[member.shown] = {
            member.kind, name, member.type, kept, member.portClass, member.registration};
    }

    /// Finds a registration under another kind: a property that became an attribute.
    const UserRegistration* callOfOtherKind(const WantedMember& member) const {
        for (const char* kind : {"port", "property", "attribute"}) {
            const bool isWanted =
                std::any_of(wanted_.members.begin(), wanted_.members.end(),
                            [&](const WantedMember& one) { return one.kind == kind && one.shown == member.shown; });
            if (isWanted) continue;
            if (const UserRegistration* call = callFor(kind, member.name, member.shown)) return call;
        }
        return nullptr;
    }

    void refuseOtherKind(const WantedMember& member, const UserRegistration& call) {
        sink_
            .error(call.where, "OC032",
                   "'" + member.shown + "' is registered by " + call.verb + "() here, and the manifest wants " +
                       (member.kind == "attribute" ? "an " : "a ") + member.kind)
            .note(member.where, "in the manifest here")
            .hint("change it by hand; then there is nothing left to do");
    }

    void plan(const WantedMember& member) {
        const auto found = recorded_.members.find(member.shown);
        const RecordedMember* last = found == recorded_.members.end() ? nullptr : &found->second;
        const UserRegistration* call = callFor(member.kind, member.name, member.shown);
        const UserField* field = call != nullptr ? fieldNamed(call->member) : nullptr;
        for (const std::string& name : {last != nullptr ? last->member : "", member.method + "_", member.method,
                                        "m_" + member.method, "_" + member.method})
            if (field == nullptr && call == nullptr && !name.empty()) field = freeField(name);
        const std::string fieldName = field != nullptr ? field->name : last != nullptr ? last->member : "";
        const bool unchanged = last != nullptr && model::normalised(last->type) == model::normalised(member.type) &&
                               (last->portClass.empty() || last->portClass == member.portClass);
        const bool takeManifest = chosen(input_.choices.manifest, member.shown);
        if (chosen(input_.choices.code, member.shown) || (unchanged && last->kept && !takeManifest))
            return keepRecord(member, fieldName, true);
        if (call == nullptr) {
            if (const UserRegistration* other = callOfOtherKind(member)) return refuseOtherKind(member, *other);
        }
        if (call != nullptr && !planCall(member.registration, last != nullptr ? &last->registration : nullptr, *call,
                                         member.kind, member.shown, member.where))
            return;
        if (field != nullptr) return planDeclared(member, *field, call, last, unchanged, takeManifest);
        // The call takes something that no class declares, such as a variable of another class.
        if (call != nullptr) return keepRecord(member, "", false);
        if (last != nullptr && unchanged && !takeManifest) {
            keepRecord(member, last->member, false);
            return warnRemoved(type_, member.kind, member.shown, member.where, sink_);
        }
        if (!canAdd(member.kind, member.shown, member.where)) return;
        const std::string name = fresh_.declare(member);
        registerField(member, name);
        keepRecord(member, name, false);
    }

    bool planCall(const Registration& wanted, const std::optional<Registration>* last, const UserRegistration& call,
                  const std::string& kind, const std::string& shown, const diag::Location& where) {
        const Registration* recorded = last != nullptr && last->has_value() ? &**last : nullptr;
        const Registered names{kind + " '" + shown + "'", shown, where, chosen(input_.choices.manifest, shown)};
        return planRegistration(wanted, recorded, call, names, input_, into_, sink_);
    }

    void registerField(const WantedMember& member, const std::string& field) {
        const Registration& how = member.registration;
        fresh_.registerBy(member.kind, member.path, how.how + "(\"" + member.name + "\", " + field + ")", how.texts);
    }

    void planDeclared(const WantedMember& member, const UserField& field, const UserRegistration* call,
                      const RecordedMember* last, bool unchanged, bool takeManifest) {
        const bool isPort = field.portClass == "InputPort" || field.portClass == "OutputPort";
        const bool samePort = isPort ? field.portClass == member.portClass : member.portClass.empty();
        if (!samePort || !hasType(field, member.type)) {
            const bool asRecorded = last != nullptr && hasType(field, last->type) &&
                                    (samePort ? true : !last->portClass.empty() && last->portClass == field.portClass);
            if (!(asRecorded && !unchanged) && !takeManifest) return conflict(member, field, last);
            if (!changeType(member, field, samePort)) return;
        }
        if (call == nullptr && last == nullptr) {
            if (!canAdd(member.kind, member.shown, member.where)) return;
            registerField(member, field.name);
        }
        keepRecord(member, field.name, false);
    }

    bool changeType(const WantedMember& member, const UserField& field, bool samePort) {
        const std::string& text = input_.code.texts.at(field.file);
        const bool portUnclear = !samePort && (member.portClass.empty() || field.portWord.empty());
        const bool sameType = !portUnclear && hasType(field, member.type);
        if (portUnclear || (!sameType && (field.type.empty() || hasComment(cut(text, field.type))))) {
            sink_
                .error(field.where, "OC032",
                       "the type of '" + field.name + "' cannot become '" + member.type +
                           "', as the manifest wants it: it is not written plainly, or several names share it")
                .note(member.where, "in the manifest here")
                .hint("change it by hand; then there is nothing left to do");
            return false;
        }
        const std::string type = member.portClass.empty() ? member.declared : member.type;
        if (!samePort) into_.edits.replace(field.file, field.portWord, member.portClass);
        if (!sameType) into_.edits.replace(field.file, field.type, type);
        into_.changes.push_back(field.file + ": '" + field.name + "' is of type " +
                                (member.portClass.empty() ? type : member.portClass + "<" + type + ">"));
        return true;
    }

    void conflict(const WantedMember& member, const UserField& field, const RecordedMember* last) {
        const auto named = [](const std::string& portClass, const std::string& type) {
            return portClass.empty() ? type : portClass + "<" + type + ">";
        };
        const std::string here = withoutLayout(cut(input_.code.texts.at(field.file), field.whole));
        auto& error = sink_.error(
            field.where, "OC031",
            member.kind + " '" + member.shown + "' is '" + here + "' here and of type '" +
                named(member.portClass, member.type) + "' in the manifest" +
                (last == nullptr ? "" : "; it was once of type '" + named(last->portClass, last->type) + "'"));
        error.note(member.where, "in the manifest here")
            .hint("'--take-manifest " + member.shown + "' changes the type here, '--take-code " + member.shown +
                  "' leaves it as it is");
    }

    bool canAdd(const std::string& kind, const std::string& shown, const diag::Location& where) {
        if (const UserRegistration* one = unclear(kind)) {
            sink_
                .error(one->where, "OC033",
                       "what this call registers cannot be told: it may be " + kind + " '" + shown + "'")
                .note(where, "wanted here")
                .hint("write the name as a text, or say that all is as it should be with '--take-code " + shown + "'");
            return false;
        }
        if (fresh_.constructor() != nullptr && !type_.isMacro) return true;
        sink_
            .error(type_.where, "OC032",
                   "class '" + type_.name + "' has no constructor with a body in this package to register " + kind +
                       " '" + shown + "' in")
            .note(where, "wanted here");
        return false;
    }

    void planOperation(const WantedMethod& method) {
        const auto last = recorded_.methods.find(method.name);
        const auto keep = [&] {
            const auto kept = into_.record[wanted_.name].methods.find(method.name);
            if (kept != into_.record[wanted_.name].methods.end()) kept->second.registration = method.registration;
        };
        if (chosen(input_.choices.code, method.shown)) return keep();
        if (const UserRegistration* call = callFor("operation", method.operation, method.shown)) {
            const auto* recorded = last == recorded_.methods.end() ? nullptr : &last->second.registration;
            if (planCall(method.registration, recorded, *call, "operation", method.shown, method.where)) keep();
            return;
        }
        keep();
        // A known operation without a call: the user removed the call on purpose.
        if (last != recorded_.methods.end() && !chosen(input_.choices.manifest, method.shown)) return;
        if (!canAdd("operation", method.shown, method.where)) return;
        fresh_.registerBy("operation", method.path, method.registrationText, method.registration.texts);
    }

    const WantedClass& wanted_;
    const model::UserClass& type_;
    const Input& input_;
    Plan& into_;
    diag::Sink& sink_;
    RecordedClass recorded_;
    NewMembers fresh_;
};

}  // namespace

void planMembers(const WantedClass& wanted, const model::UserClass& type, const Input& input, Plan& into,
                 diag::Sink& sink) {
    MemberPlanner(wanted, type, input, into, sink).run();
}

}  // namespace oroforge::merge
