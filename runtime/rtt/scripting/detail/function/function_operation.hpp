// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions of scripts as operations, for C++ code, consoles, other components, and scripts that no engine executes.
#ifndef ORO_SCRIPTING_DETAIL_FUNCTION_OPERATION_HPP
#define ORO_SCRIPTING_DETAIL_FUNCTION_OPERATION_HPP

#include <rtt/internal/calls/operation_signature.hpp>
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

/** The signature of a function. */
class FunctionSignature : public internal::SignedPart {
public:
    std::string getName() const override;
    std::string description() const override;
    internal::OperationSignature signature() const override { return signature_; }
    base::DataSourceBase::shared_ptr produceHandle() const override;

protected:
    /** `pattern` has the types. */
    FunctionSignature(std::shared_ptr<const FunctionDefinition> definition, const Activation& pattern);

    /** The handle of a call that is to be collected. Throws if the arguments do not fit. */
    FunctionHandle::shared_ptr handleIn(const Args& args) const;

private:
    const std::shared_ptr<const FunctionDefinition> definition_;
    internal::OperationSignature signature_;
};

/** Each source that calls takes its own execution of the function when it is made; one that sends takes several. So
    calling and sending are as real-time safe as the function. */
class FunctionPart final : public FunctionSignature {
public:
    FunctionPart(std::shared_ptr<FunctionPool> pool, const Activation& pattern);
    /** True if the component that executes it was destroyed. */
    bool isLost() const { return pool_->owner()->gate->closed(); }

    base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const override;

private:
    const std::shared_ptr<FunctionPool> pool_;
};

/** An operation of a script that is only checked: calls execute nothing. */
class UnexecutedPart final : public FunctionSignature {
public:
    UnexecutedPart(std::shared_ptr<const FunctionDefinition> definition, const Activation& pattern)
        : FunctionSignature(std::move(definition), pattern),
          result_(pattern.result ? pattern.result->clone() : nullptr) {}

    base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const override;

private:
    const base::DataSourceBase::shared_ptr result_;  // null for void
};

/** Breaks a cycle at the end of a script: a handle of one of its functions keeps the function, which keeps the file of
    the handle. Code that uses the handle has what it needs. */
void letGoOfFunctions(const Scope& script);

/** The service that has functions of that scope as operations; null if that is the service `scripting` and that is
    null. */
Service* homeOf(ast::Function::Scope scope, Service* scripting, TaskContext& component);

/** Reports an error to `*where.sink` and returns false if that scope has an operation of its name that is not a
    function of a script. `scripting` is null if the component has no such service. */
bool hasFreeName(const FunctionDefinition& definition, ast::Function::Scope scope, Service* scripting,
                 const CompileContext& where);

/**
 * Checks the function and adds it as an operation to the service `scripting`, the component or the GlobalService. It
 * replaces an existing function in later look-ups. If it does not compile, or if there is an operation of its name that
 * is not a function of a script, reports errors to `*where.sink` and returns false.
 */
bool addFunction(std::shared_ptr<const FunctionDefinition> definition, ast::Function::Scope scope, Service& scripting,
                 const CompileContext& where);

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
