// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/function/function_operation.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/scripting/detail/function/function_sources.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::scripting::detail {

using base::DataSourceBase;

namespace {

// The most functions compiled at once: a chain of functions would be compiled again for each that is added to it.
constexpr std::size_t kMostAtOnce = 50;

/** The context for a function that the engine of its component executes. */
CompileContext ofItself(CompileContext where, oroforge::diag::Sink& sink) {
    where.caller = where.component->engine();
    where.sink = &sink;
    return where;
}

/** A value of the type of `of`; of type void if that is null. */
internal::OperationSignature::Value valueLike(const DataSourceBase::shared_ptr& of) {
    const types::TypeInfo* const type = of ? of->getTypeInfo() : internal::DataSource<void>::GetTypeInfo();
    return {type, type->getTypeId(), type->getTypeName(), false, false, false, "", ""};
}

oroforge::diag::Location placeOf(const FunctionDefinition& definition) {
    const ast::Place at = definition.tree->name.at;
    return {definition.file, at.line, at.column};
}

}  // namespace

void letGoOfFunctions(const Scope& script) {
    for (const auto& named : script.entries())
        if (named.second.handle && dynamic_cast<const FunctionSignature*>(named.second.handle->operation().get()))
            named.second.handle->clear();
}

Service* homeOf(ast::Function::Scope scope, Service* scripting, TaskContext& component) {
    switch (scope) {
        case ast::Function::Scope::Exported: return component.provides().get();
        case ast::Function::Scope::Global: return internal::GlobalService::Instance().get();
        case ast::Function::Scope::Local: break;
    }
    return scripting;
}

FunctionSignature::FunctionSignature(std::shared_ptr<const FunctionDefinition> definition, const Activation& pattern)
    : definition_(std::move(definition)) {
    signature_.result = valueLike(pattern.result);
    for (const DataSourceBase::shared_ptr& argument : pattern.arguments) {
        const std::size_t index = signature_.arguments.size();
        signature_.arguments.push_back(valueLike(argument));
        signature_.arguments.back().name = definition_->tree->arguments[index].name.text;
    }
}

std::string FunctionSignature::getName() const { return definition_->name; }
std::string FunctionSignature::description() const { return "A function of a script."; }

DataSourceBase::shared_ptr FunctionSignature::produceHandle() const {
    return new internal::ValueDataSource<FunctionCall::shared_ptr>();
}

FunctionHandle::shared_ptr FunctionSignature::handleIn(const Args& args) const {
    FunctionHandle::shared_ptr const handle = FunctionHandle::narrow(args.empty() ? nullptr : args[0].get());
    checkCollected(args, handle != nullptr);
    return handle;
}

FunctionPart::FunctionPart(std::shared_ptr<FunctionPool> pool, const Activation& pattern)
    : FunctionSignature(std::shared_ptr<const FunctionDefinition>(pool, &pool->definition()), pattern),
      pool_(std::move(pool)) {}

DataSourceBase::shared_ptr FunctionPart::produce(const Args& args, ExecutionEngine* caller) const {
    return makeCallSource({pool_, checkedArguments(args), caller ? caller->gate() : nullptr});
}

DataSourceBase::shared_ptr FunctionPart::produceSend(const Args& args, ExecutionEngine* caller) const {
    return makeSendSource({pool_, checkedArguments(args), caller ? caller->gate() : nullptr});
}

DataSourceBase::shared_ptr FunctionPart::produceCollect(const Args& args,
                                                        internal::DataSource<bool>::shared_ptr blocking) const {
    return makeCollectSource(pool_->owner(), handleIn(args), args.size() > 1 ? args[1] : nullptr, std::move(blocking));
}

DataSourceBase::shared_ptr UnexecutedPart::produce(const Args& args, ExecutionEngine*) const {
    (void)checkedArguments(args);
    if (!result_) return new internal::FusedFunctorDataSource<void()>([] {}, Args());
    return result_->clone();
}

DataSourceBase::shared_ptr UnexecutedPart::produceSend(const Args& args, ExecutionEngine*) const {
    (void)checkedArguments(args);
    return produceHandle();
}

DataSourceBase::shared_ptr UnexecutedPart::produceCollect(const Args& args,
                                                          internal::DataSource<bool>::shared_ptr) const {
    (void)handleIn(args);
    return new internal::ValueDataSource<SendStatus>(SendNotReady);
}

bool hasFreeName(const FunctionDefinition& definition, ast::Function::Scope scope, Service* scripting,
                 const CompileContext& where) {
    Service* const home = homeOf(scope, scripting, *where.component);
    const OperationInterfacePart* const taken = home ? home->getPart(definition.name) : nullptr;
    if (!taken || dynamic_cast<const FunctionSignature*>(taken)) return true;
    where.sink->error(placeOf(definition), "OPS204",
                      "function '" + definition.name + "' cannot be added: '" + home->getName() +
                          "' has an operation of that name, which no script defined");
    return false;
}

bool addFunction(std::shared_ptr<const FunctionDefinition> definition, ast::Function::Scope scope, Service& scripting,
                 const CompileContext& where) {
    if (!hasFreeName(*definition, scope, &scripting, where)) return false;
    const std::string& name = definition->name;
    const oroforge::diag::Location place = placeOf(*definition);
    Service& home = *homeOf(scope, &scripting, *where.component);
    const auto* const known = dynamic_cast<const FunctionPart*>(home.getPart(name));
    oroforge::diag::Sink found;
    const std::unique_ptr<Activation> pattern = Compiler(ofItself(where, found)).check(*definition);
    const bool isSmall = definition->size <= kMostAtOnce;
    const auto pool = std::make_shared<FunctionPool>(std::move(definition), where);
    if (isSmall) {
        // Reports the same errors, and compiles the function so that the first caller need not wait.
        if (!pool->take(*where.sink)) return false;
    } else {
        for (const auto& each : found.all()) where.sink->add(each);
    }
    if (!pattern) return false;
    if (known && !known->isLost())
        where.sink->warning(place, "OPS205",
                            "function '" + name +
                                "' is defined again: what is loaded already goes on "
                                "with the one it knows");
    home.add(name, new FunctionPart(pool, *pattern));
    if (scope == ast::Function::Scope::Exported)
        log(Info) << "component '" << where.component->getName() << "' has function '" << name << "' as operation now"
                  << endlog();
    return true;
}

}  // namespace RTT::scripting::detail
