// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_builder.hpp>

#include <rtt/TaskContext.hpp>

#include <boost/make_shared.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

MachineBuilder::MachineBuilder(const ast::Instance& instance, const Context& context)
    : instance_(instance),
      context_(context),
      type_(*context.known.at(instance.type.text)),
      tree_(*type_.tree),
      where_(context.where),
      scope_("state machine '" + instance.name.text + "'", &type_.file->scope),
      slot_(std::make_shared<boost::weak_ptr<StateMachine>>()),
      model_(std::make_unique<MachineModel>()),
      transitions_(where_),
      events_(where_, *model_, transitions_) {
    where_.file = type_.file->name;
    where_.text = partOf(type_.file, type_.file->text);
    model_->name = (context.outer ? context.outer->model_->name + "." : "") + instance.name.text;
    model_->text = type_.text;
    model_->firstLine = type_.at.line;
    model_->source = type_.file;
}

// A redefined type may refer to the former one, which may refer to the new one.
bool MachineBuilder::isPartOfItself() const {
    for (const MachineBuilder* outer = context_.outer; outer; outer = outer->context_.outer)
        if (outer->tree_.type.text == tree_.type.text) return true;
    return false;
}

StateMachinePtr MachineBuilder::build() {
    const std::size_t errors = where_.sink->errorCount();
    if (isPartOfItself()) {
        context_.where.sink->error({context_.where.file, instance_.at.line, instance_.at.column}, "OPS315",
                                   "a state machine of type '" + tree_.type.text + "' cannot be a part of itself");
        return nullptr;
    }
    makeService();
    declare();
    makeSubMachines();
    makeStates();
    if (where_.sink->errorCount() == errors) {
        if (events_.hasEvents()) model_->queue = std::make_shared<EventQueue>(where_.component->engine()->gate());
        const std::shared_ptr<EventQueue> queue = model_->queue;
        const auto machine = boost::make_shared<StateMachine>(std::move(model_));
        *slot_ = machine;
        if (queue) queue->leadTo(machine);
        events_.listen(queue);
        return machine;
    }
    context_.service.removeService(instance_.name.text);
    return nullptr;
}

void MachineBuilder::makeService() {
    model_->service = boost::make_shared<Service>(instance_.name.text, where_.component);
    model_->service->doc("The state machine '" + model_->name + "' of a script, of type '" + tree_.type.text + "'.");
    addMachineOperations(*model_->service, slot_);
    context_.service.addService(model_->service);
    where_.service = model_->service.get();
}

void MachineBuilder::declare() {
    std::vector<const ast::Statement*> parameters, others;
    for (const ast::StatementPtr& statement : tree_.locals) {
        const auto* const declaration = std::get_if<ast::Declaration>(&statement->what);
        const bool parameter = declaration && declaration->kind == ast::Declaration::Kind::Parameter;
        (parameter ? parameters : others).push_back(statement.get());
    }
    declare(parameters, scope_);
    assignParameters();
    declare(others, scope_);
    addMachineValues(*model_->service, scope_);
}

void MachineBuilder::declare(const std::vector<const ast::Statement*>& statements, Scope& scope) {
    for (const ast::Statement* statement : statements)
        if (RoutinePtr values =
                makeRoutine(Compiler(where_).statement(*statement, scope), where_, CodeRoutine::Pace::AtOnce))
            model_->initial.push_back(std::move(values));
}

// Constants are computed when the machine is made, and may depend on parameters.
bool MachineBuilder::hasConstants() const {
    const auto isConstant = [](const ast::StatementPtr& statement) {
        const auto* const declaration = std::get_if<ast::Declaration>(&statement->what);
        return declaration && declaration->kind == ast::Declaration::Kind::Constant;
    };
    const auto within = [&](const std::vector<ast::StatementPtr>& locals) {
        return std::any_of(locals.begin(), locals.end(), isConstant);
    };
    return within(tree_.locals) || std::any_of(tree_.states.begin(), tree_.states.end(),
                                               [&](const ast::State& state) { return within(state.locals); });
}

void MachineBuilder::assignParameters() {
    const bool now = hasConstants() && !where_.checkOnly;
    for (const ast::Instance::Argument& argument : instance_.arguments) {
        const Scope::Entry* const parameter = scope_.findHere(argument.name.text);
        if (!parameter || !parameter->source) continue;
        auto code = Compiler(context_.where)
                        .assignment(parameter->source, *argument.value, "parameter '" + argument.name.text + "'",
                                    context_.scope);
        if (!code) continue;
        RoutinePtr value = std::make_unique<CodeRoutine>(std::move(code), context_.where, CodeRoutine::Pace::AtOnce);
        if (now && value->run() != Routine::Outcome::Finished)
            context_.where.sink->error(
                {context_.where.file, argument.value->at.line, argument.value->at.column}, "OPS316",
                "the value of parameter '" + argument.name.text + "' cannot be computed: " + value->failure());
        model_->initial.push_back(std::move(value));
    }
}

void MachineBuilder::makeSubMachines() {
    for (const ast::Instance& instance : tree_.subMachines) {
        if (!checkInstance(instance, context_.known, where_.file, where_)) continue;
        const Context inner{context_.known, scope_, where_, *model_->service, this};
        if (StateMachinePtr child = MachineBuilder(instance, inner).build())
            model_->children.push_back(std::move(child));
    }
}

void MachineBuilder::makeStates() {
    for (const ast::State& tree : tree_.states) {
        MachineState& state = model_->states.emplace_back();
        state.name = tree.name.text;
        transitions_.addState(state);
        if (tree.initial) model_->first = &state;
        if (tree.final) model_->last = &state;
    }
    auto state = model_->states.begin();
    for (const ast::State& tree : tree_.states) fillState(tree, *state++);
    for (const ast::Transition& tree : tree_.transitions) events_.add(tree, scope_, model_->transitions, nullptr);
}

void MachineBuilder::fillState(const ast::State& tree, MachineState& state) {
    const std::string name = "state '" + state.name + "'";
    const Scope& before = state_scopes_.empty() ? scope_ : *state_scopes_.back();
    state_scopes_.push_back(std::make_unique<Scope>(name, &before));
    Scope& scope = *state_scopes_.back();
    if (!tree.locals.empty())
        state.locals =
            makeRoutine(Compiler(where_).declarations(tree.locals, scope), where_, CodeRoutine::Pace::AtOnce);
    state.entry = makeProgram(tree.entry, "the entry of " + name, scope, where_);
    state.run = makeProgram(tree.run, "the run program of " + name, scope, where_);
    state.handle = makeProgram(tree.handle, "the handle program of " + name, scope, where_);
    state.exit = makeProgram(tree.exit, "the exit of " + name, scope, where_);
    for (const ast::ExpressionPtr& condition : tree.preconditions)
        if (GuardPtr made = makeGuard(*condition, scope, where_)) state.preconditions.push_back(std::move(made));
    for (const ast::Transition& detour : tree.detours) state.detours.push_back(transitions_.build(detour, scope));
    for (const ast::Transition& transition : tree.transitions)
        events_.add(transition, scope, state.transitions, &state);
}

StateMachinePtr makeMachine(const ast::Instance& root, const MachineTypes& known, const SourceFile& file,
                            const CompileContext& where) {
    if (!checkInstance(root, known, file.name, where)) return nullptr;
    CompileContext here = where;
    here.peers = std::make_shared<Peers>();
    const MachineBuilder::Context context{known, file.scope, here, *where.component->provides(), nullptr};
    return MachineBuilder(root, context).build();
}

}  // namespace RTT::scripting::detail
