// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What calls of the deployer's operations lead to, for scripts that are checked.
#ifndef OROFORGE_DEPLOYMENT_SCRIPT_FORECAST_HPP
#define OROFORGE_DEPLOYMENT_SCRIPT_FORECAST_HPP

#include "session.hpp"

#include <rtt/scripting/check.hpp>

#include <string>

namespace OCL::deploy {

/**
 * Does the imports that a script is certain to do. What else becomes of the calls: `Foresight::Run` is for a script that runs
 * afterwards: components are expected, not made, and what the operations will tell by themselves is left to them.
 * `Foresight::Check` makes the components, whose operations are known then, and tells what will fail.
 */
enum class Foresight { Run, Check };

class ScriptForecast final : public RTT::scripting::CallForecast {
public:
    ScriptForecast(Session& session, Foresight foresight) : session_(session), foresight_(foresight) {}

    RTT::scripting::CallProblem foresee(const RTT::scripting::ForeseenCall& call,
                                        RTT::scripting::Expectations& expected) override;

private:
    typedef RTT::scripting::CallProblem Problem;
    typedef RTT::scripting::ForeseenCall Call;
    typedef RTT::scripting::Expectations Expectations;

    Problem callOfDeployer(const std::string& operation, const Call& call, Expectations& expected);
    Problem import(const Call& call, bool isLibrary, Expectations& expected);
    Problem path(const Call& call, Expectations& expected);
    Problem component(const Call& call, Expectations& expected);
    Problem peers(const std::string& operation, const Call& call, Expectations& expected);
    Problem service(const Call& call, Expectations& expected);
    Problem require(const Call& call, Expectations& expected);
    Problem change(const Call& call, Expectations& expected);
    Problem names(const std::string& operation, const Call& call, const Expectations& expected) const;
    Problem name(const std::string& given, bool isPort, const Expectations& expected) const;
    bool tells(const Call& call, const Expectations& expected) const;
    void touch(RTT::TaskContext& component, Expectations& expected) const;
    /** All components may have more than they have now. */
    void touchAll(Expectations& expected) const;

    Session& session_;
    const Foresight foresight_;
};

}  // namespace OCL::deploy

#endif
