// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/plan.hpp>

#include <algorithm>

#include <merge/plan_methods.hpp>
#include <merge/text_places.hpp>
#include <model/names.hpp>

namespace oroforge::merge {

namespace {

const model::UserClass* classNamed(const model::UserCode& code, const std::string& name) {
    for (const model::UserClass& one : code.classes)
        if (one.name == name && !one.file.empty()) return &one;
    return nullptr;
}

/// Reports methods that only the record has, and leaves them alone.
void tellRemoved(const std::string& name, const RecordedClass& recorded, const WantedClass* wanted,
                 const model::UserClass& type, Plan& into, diag::Sink& sink) {
    const auto isWanted = [&](const std::string& method) {
        return wanted != nullptr && std::any_of(wanted->methods.begin(), wanted->methods.end(),
                                                [&](const WantedMethod& one) { return one.name == method; });
    };
    for (const auto& [method, what] : recorded.methods) {
        if (isWanted(method)) continue;
        for (const model::UserFunction& function : type.functions) {
            if (function.name != method || !function.inClass) continue;
            into.record[name].methods[method] = what;
            sink.note(
                function.where,
                std::string(what.isHook ? "hook '" : "operation '") + method +
                    "' is no longer in the manifest; remove this by hand" +
                    (function.saysOverride && !what.isHook ? " (with 'override' it does not compile any more)" : ""));
            break;
        }
    }
    const auto isWantedMember = [&](const std::string& member) {
        return wanted != nullptr && std::any_of(wanted->members.begin(), wanted->members.end(),
                                                [&](const WantedMember& one) { return one.shown == member; });
    };
    for (const auto& [member, what] : recorded.members) {
        if (isWantedMember(member)) continue;
        for (const model::UserField& field : type.fields) {
            if (field.name != what.member) continue;
            into.record[name].members[member] = what;
            sink.note(field.where, what.kind + " '" + member + "' is no longer in the manifest; remove this by hand");
        }
    }
}

}  // namespace

bool isChosen(const std::set<std::string>& names, const std::string& className, const std::string& name) {
    return names.count(name) != 0 || names.count(model::lastName(className) + "." + name) != 0;
}

std::string question(const model::Signature& signature) {
    model::Signature bare = signature;
    for (model::TypedName& argument : bare.arguments) argument.name.clear();
    return toText(bare, "f");
}

std::vector<model::Signature> questionsOf(const WantedClass& wanted, const RecordedClass* recorded) {
    std::vector<model::Signature> all;
    for (const WantedMethod& method : wanted.methods) all.push_back(method.signature);
    for (const WantedMember& member : wanted.members) all.push_back({"void", {{member.type, ""}}});
    if (recorded == nullptr) return all;
    for (const auto& [name, method] : recorded->methods) all.push_back(method.signature);
    for (const auto& [name, member] : recorded->members) all.push_back({"void", {{member.type, ""}}});
    return all;
}

Plan plan(const std::vector<WantedClass>& wanted, const Input& input, diag::Sink& sink) {
    Plan result;
    std::set<std::string> known;
    for (const WantedClass& one : wanted) {
        known.insert(one.name);
        const model::UserClass* type = classNamed(input.code, one.name);
        if (type == nullptr) continue;
        planMethods(one, *type, input, result, sink);
        if (!type->hasGeneratedBase) planMembers(one, *type, input, result, sink);
        const auto recorded = input.record.find(one.name);
        if (recorded != input.record.end()) tellRemoved(one.name, recorded->second, &one, *type, result, sink);
    }
    for (const auto& [name, recorded] : input.record) {
        if (known.count(name) != 0) continue;
        const model::UserClass* type = classNamed(input.code, name);
        if (type == nullptr) continue;
        sink.note(type->where, "class '" + name + "' is no longer in the manifest; its files are yours to remove");
        result.record[name] = recorded;
    }
    return result;
}

RecordedClass recordOf(const WantedClass& wanted) {
    RecordedClass record;
    for (const WantedMethod& method : wanted.methods)
        record.methods[method.name] = {method.signature, method.isHook, false};
    return record;
}

}  // namespace oroforge::merge
