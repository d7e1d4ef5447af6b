// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The functions of scripts as operations: for C++, consoles, other components, and scripts that no engine executes.
#ifndef ORO_SCRIPTING_DETAIL_FUNCTION_OPERATION_HPP
#define ORO_SCRIPTING_DETAIL_FUNCTION_OPERATION_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/scripting/detail/function/function_pool.hpp>
#include <rtt/scripting/detail/function/function_sources.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace RTT {
class Service;
namespace scripting {
namespace detail {

/** What a function takes and gives. */
class FunctionSignature : public OperationInterfacePart {
public:
    std::string getName() const override;
    std::string description() const override;
    std::vector<ArgumentDescription> getArgumentList() const override;
    std::string resultType() const override;
    unsigned arity() const override;
    const types::TypeInfo* getArgumentType(unsigned index) const override;
    unsigned collectArity() const override;
    const types::TypeInfo* getCollectType(unsigned index) const override;
    base::DataSourceBase::shared_ptr produceHandle() const override;

protected:
    /** `pattern` has the types. */
    FunctionSignature(std::shared_ptr<const FunctionDefinition> definition, const Activation& pattern);

    /** Of the types that the function takes. */
    Args checked(const Args& args) const;
    /** What collects a call: its handle, and the variable for the result, or null. */
    struct Collected {
        FunctionHandle::shared_ptr handle;
        base::DataSourceBase::shared_ptr variable;
    };
    Collected collected(const Args& args) const;
    /** Null for void. */
    const base::DataSourceBase::shared_ptr& result() const { return values_.front(); }

private:
    const std::shared_ptr<const FunctionDefinition> definition_;
    std::vector<base::DataSourceBase::shared_ptr>
        values_;  // of the types of the result, null for void, and the arguments
};

/** Each source that calls has an execution of the function of its own, which it takes when it is made; one that sends has
    several. So calling and sending are as real-time safe as the function is. */
class FunctionPart final : public FunctionSignature {
public:
    FunctionPart(std::shared_ptr<FunctionPool> pool, const Activation& pattern);
    /** The component that executes it was destroyed. */
    bool isLost() const { return pool_->owner()->gate->closed(); }

    base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const override;

private:
    const std::shared_ptr<FunctionPool> pool_;
};

/** Of a script that is only looked through: nothing is executed, whoever calls. */
class UnexecutedPart final : public FunctionSignature {
public:
    UnexecutedPart(std::shared_ptr<const FunctionDefinition> definition, const Activation& pattern)
        : FunctionSignature(std::move(definition), pattern) {}

    base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const override;
};

/** At the end of a script: a handle of one of its functions keeps the function, which keeps the file in which the handle
    stands. The code that uses it has what it needs. */
void letGoOfFunctions(const Scope& script);

/** The service that has the functions of that scope as operations; null for the service `scripting` if that is. */
Service* homeOf(ast::Function::Scope scope, Service* scripting, TaskContext& component);

/** False, with an error in `*where.sink`, if there is an operation of its name in that scope that is no function of a
    script. `scripting` may be null if the component has no such service. */
bool hasFreeName(const FunctionDefinition& definition, ast::Function::Scope scope, Service* scripting,
                 const Surroundings& where);

/**
 * Checks the function, and adds it as operation to the service `scripting`, to the component or to the GlobalService. One
 * that is there is replaced for those who look it up from now on. False, with the errors in `*where.sink`, if it does not
 * compile, or if there is an operation of its name that is no function of a script.
 */
bool addFunction(std::shared_ptr<const FunctionDefinition> definition, ast::Function::Scope scope, Service& scripting,
                 const Surroundings& where);

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
