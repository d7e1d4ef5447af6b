// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_TOLD_CALL_HPP
#define ORO_SCRIPTING_DETAIL_TOLD_CALL_HPP

#include <rtt/internal/DataSource.hpp>
#include <rtt/scripting/detail/execute/failed_call.hpp>

#include <map>
#include <string>

namespace RTT::scripting::detail {

/**
 * Calls an operation that gives reasons when it returns false (internal::FailureReport), and logs them with the place
 * of the call. If failures are strict and the script ignores the result, the statement fails.
 */
class ToldCall final : public internal::DataSource<bool> {
public:
    ToldCall(internal::DataSource<bool>* call, CallPlace place, bool ignored);

    bool evaluate() const override;
    bool get() const override;
    bool value() const override { return call_->value(); }
    const bool& rvalue() const override { return call_->rvalue(); }
    ToldCall* clone() const override;
    ToldCall* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override;

private:
    void tell(const std::string& reasons) const;

    const internal::DataSource<bool>::shared_ptr call_;
    const CallPlace place_;
    const bool ignored_;
};

}  // namespace RTT::scripting::detail

#endif
