// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Data sources that call and send a function of a script, and collect what it returned.
#ifndef ORO_SCRIPTING_DETAIL_FUNCTION_SOURCES_HPP
#define ORO_SCRIPTING_DETAIL_FUNCTION_SOURCES_HPP

#include <rtt/internal/DataSource.hpp>
#include <rtt/scripting/detail/function/function_pool.hpp>

#include <map>
#include <memory>
#include <vector>

namespace RTT::scripting::detail {

typedef internal::DataSource<FunctionCall::shared_ptr> FunctionHandle;
typedef std::map<const base::DataSourceBase*, base::DataSourceBase*> CopyMap;

/** The use of a function: the caller and the arguments. */
struct FunctionUse {
    std::shared_ptr<FunctionPool> pool;
    std::vector<base::DataSourceBase::shared_ptr> arguments;  ///< with the types that the function takes
    boost::intrusive_ptr<const internal::EngineGate> caller;  ///< or null

    /** Throws std::runtime_error if an argument has no value. */
    void evaluateArguments() const;
    FunctionUse copy(CopyMap& cloned) const;
};

/** A source, with the type of the result, that calls at each evaluation. Throws what FunctionCall::call() throws. */
base::DataSourceBase::shared_ptr makeCallSource(FunctionUse use);

/** A source that sends at each evaluation; its value is the handle. If the function is refused, or too many sent calls
    are not done, evaluation is false and the handle null. */
FunctionHandle::shared_ptr makeSendSource(FunctionUse use);

/** A source that collects at each evaluation, and assigns the result to `variable` unless that is null. */
base::DataSourceBase::shared_ptr makeCollectSource(std::shared_ptr<FunctionOwner> owner,
                                                   FunctionHandle::shared_ptr handle,
                                                   base::DataSourceBase::shared_ptr variable,
                                                   internal::DataSource<bool>::shared_ptr blocking);

}  // namespace RTT::scripting::detail

#endif
