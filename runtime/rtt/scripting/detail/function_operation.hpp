// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The functions of scripts as operations: for C++, consoles, other components, and scripts that no engine executes.
#ifndef ORO_SCRIPTING_DETAIL_FUNCTION_OPERATION_HPP
#define ORO_SCRIPTING_DETAIL_FUNCTION_OPERATION_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/scripting/detail/function_pool.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
class Service;
namespace scripting {
namespace detail {

/** Each source that calls has an execution of the function of its own, which it takes when it is made; one that sends has
    several. So calling and sending are as real-time safe as the function is. */
class FunctionPart final : public OperationInterfacePart {
public:
    /** `pattern` has the types. */
    FunctionPart(std::shared_ptr<FunctionPool> pool, const Activation& pattern);
    /** The component that executes it was destroyed. */
    bool isLost() const { return pool_->owner()->gate->closed(); }

    std::string getName() const override;
    std::string description() const override;
    std::vector<ArgumentDescription> getArgumentList() const override;
    std::string resultType() const override;
    unsigned arity() const override;
    const types::TypeInfo* getArgumentType(unsigned index) const override;
    unsigned collectArity() const override;
    const types::TypeInfo* getCollectType(unsigned index) const override;

    base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceHandle() const override;
    base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const override;

private:
    Args checked(const Args& args) const;

    const std::shared_ptr<FunctionPool> pool_;
    std::vector<base::DataSourceBase::shared_ptr>
        values_;  // of the types of the result, null for void, and the arguments
};

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
