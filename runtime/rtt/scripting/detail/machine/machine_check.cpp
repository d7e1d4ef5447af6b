// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Checks of a state machine that need no component.
#include <rtt/scripting/detail/machine/machine_build.hpp>

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

namespace diag = oroforge::diag;

namespace {

std::string quoted(const ast::Identifier& name) { return "'" + name.text + "'"; }

/** The declared parameters, in their order. */
std::vector<const ast::Declarator*> parametersOf(const ast::StateMachine& tree) {
    std::vector<const ast::Declarator*> found;
    for (const auto& statement : tree.locals) {
        const auto* const declaration = std::get_if<ast::Declaration>(&statement->what);
        if (!declaration || declaration->kind != ast::Declaration::Kind::Parameter) continue;
        for (const ast::Declarator& declarator : declaration->names) found.push_back(&declarator);
    }
    return found;
}

class Check {
public:
    Check(const MachineType& type, const MachineTypes& known, const CompileContext& where)
        : tree_(*type.tree), file_(type.file->name), known_(known), where_(where) {}

    bool all() {
        const std::size_t before = where_.sink->errorCount();
        states();
        for (const ast::Transition& transition : tree_.transitions) target(transition);
        for (const ast::State& state : tree_.states) {
            for (const ast::Transition& detour : state.detours) target(detour);
            for (const ast::Transition& transition : state.transitions) target(transition);
        }
        subMachines();
        return where_.sink->errorCount() == before;
    }

private:
    diag::Location at(ast::Place place) const { return {file_, place.line, place.column}; }

    void states() {
        if (tree_.states.empty()) {
            where_.sink->error(
                at(tree_.end), "OPS302",
                "state machine type " + quoted(tree_.type) + " has no states, expected an initial and a final one");
            return;
        }
        for (const ast::State& state : tree_.states) {
            names_.push_back(state.name.text);
            const auto added = states_.emplace(state.name.text, state.name.at);
            if (!added.second)
                where_.sink->error(at(state.name.at), "OPS304", "state " + quoted(state.name) + " is defined twice")
                    .note(at(added.first->second), "first defined here");
        }
        exactlyOne("initial", &ast::State::initial);
        exactlyOne("final", &ast::State::final);
    }

    void exactlyOne(const std::string& kind, bool ast::State::*flag) {
        const ast::State* first = nullptr;
        for (const ast::State& state : tree_.states) {
            if (!(state.*flag)) continue;
            if (first)
                where_.sink->error(at(state.name.at), "OPS302", "found a second " + kind + " state, expected one")
                    .note(at(first->name.at), "the first is " + quoted(first->name));
            else
                first = &state;
        }
        if (!first)
            where_.sink->error(at(tree_.type.at), "OPS302",
                               "state machine type " + quoted(tree_.type) + " has no " + kind + " state");
    }

    void target(const ast::Transition& transition) {
        target(transition.selection);
        if (transition.otherwise) target(*transition.otherwise);
    }

    void target(const ast::Selection& selection) {
        for (const ast::Identifier& state : selection.states)
            if (!states_.count(state.text) && !states_.empty())
                where_.sink->error(at(state.at), "OPS306",
                                   "there is no state " + quoted(state) + " in " + quoted(tree_.type) +
                                       diag::didYouMean(state.text, names_));
    }

    void subMachines() {
        std::map<std::string, ast::Place> seen;
        for (const auto& statement : tree_.locals)
            if (const auto* const declaration = std::get_if<ast::Declaration>(&statement->what))
                for (const ast::Declarator& declarator : declaration->names)
                    seen.emplace(declarator.name.text, declarator.name.at);
        for (const ast::Instance& instance : tree_.subMachines) {
            const auto added = seen.emplace(instance.name.text, instance.name.at);
            if (!added.second)
                where_.sink
                    ->error(at(instance.name.at), "OPS307",
                            quoted(instance.name) + " is already declared in " + quoted(tree_.type))
                    .note(at(added.first->second), "first declared here");
            checkInstance(instance, known_, file_, where_);
        }
    }

    const ast::StateMachine& tree_;
    const diag::FileName file_;
    const MachineTypes& known_;
    const CompileContext& where_;
    std::map<std::string, ast::Place> states_;
    std::vector<std::string> names_;
};

}  // namespace

bool checkMachineType(const MachineType& type, const MachineTypes& known, const CompileContext& where) {
    return Check(type, known, where).all();
}

bool checkInstance(const ast::Instance& instance, const MachineTypes& known, const diag::FileName& file,
                   const CompileContext& where) {
    const auto at = [&](ast::Place place) { return diag::Location{file, place.line, place.column}; };
    const auto found = known.find(instance.type.text);
    if (found == known.end()) {
        if (where.toCome && where.toCome->mayHave(where.component, instance.type.text, false)) return false;
        std::vector<std::string> names;
        for (const auto& each : known) names.push_back(each.first);
        where.sink->error(
            at(instance.type.at), "OPS305",
            "there is no state machine type " + quoted(instance.type) + diag::didYouMean(instance.type.text, names));
        return false;
    }
    const std::size_t before = where.sink->errorCount();
    std::map<std::string, ast::Place> given;
    std::vector<std::string> names;
    for (const ast::Declarator* parameter : parametersOf(*found->second->tree)) names.push_back(parameter->name.text);
    for (const ast::Instance::Argument& argument : instance.arguments) {
        const auto added = given.emplace(argument.name.text, argument.name.at);
        if (!added.second)
            where.sink->error(at(argument.name.at), "OPS310", "parameter " + quoted(argument.name) + " is given twice")
                .note(at(added.first->second), "first given here");
        else if (std::find(names.begin(), names.end(), argument.name.text) == names.end())
            where.sink->error(at(argument.name.at), "OPS308",
                              "state machine type " + quoted(instance.type) + " has no parameter " +
                                  quoted(argument.name) + diag::didYouMean(argument.name.text, names));
    }
    for (const ast::Declarator* parameter : parametersOf(*found->second->tree))
        if (!given.count(parameter->name.text))
            where.sink
                ->error(at(instance.name.at), "OPS309",
                        "state machine " + quoted(instance.name) + " is given no value for parameter " +
                            quoted(parameter->name))
                .note({found->second->file->name, parameter->name.at.line, parameter->name.at.column}, "declared here");
    return where.sink->errorCount() == before;
}

}  // namespace RTT::scripting::detail
