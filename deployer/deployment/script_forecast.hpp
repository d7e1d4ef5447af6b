// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What calls of the deployer's operations lead to, for scripts that are checked.
#ifndef OROFORGE_DEPLOYMENT_SCRIPT_FORECAST_HPP
#define OROFORGE_DEPLOYMENT_SCRIPT_FORECAST_HPP

#include "call_effects.hpp"
#include "session.hpp"

#include <rtt/scripting/check.hpp>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace OCL::deploy {

enum class Foresight {
    Run,  ///< for a script that runs afterwards: tells only what is certain whatever code of others does; makes no components
    Check  ///< for a script that does not run: makes the components, whose operations are known then, and tells what will fail
};

/** An argument that is a text as it stands in the script; null: it is none. */
inline const std::string* textOf(const RTT::scripting::ForeseenCall& call, std::size_t argument) {
    return argument < call.texts.size() ? call.texts[argument] : nullptr;
}

/** Does the imports that a script is certain to do; of one that runs afterwards, those that it does before anything else. */
class ScriptForecast final : public RTT::scripting::CallForecast {
public:
    ScriptForecast(Session& session, Foresight foresight) : session_(session), foresight_(foresight) {}

    /** What components that are running now may do at any time. */
    void expectRunning(RTT::scripting::Expectations& expected) const;
    RTT::scripting::CallProblem foresee(const RTT::scripting::ForeseenCall& call,
                                        RTT::scripting::Expectations& expected) override;

private:
    typedef RTT::scripting::CallProblem Problem;
    typedef RTT::scripting::ForeseenCall Call;
    typedef RTT::scripting::Expectations Expectations;

    Problem callOfDeployer(const std::string& operation, const Call& call, Expectations& expected);
    void callOfOthers(const std::vector<std::string>& path, Expectations& expected) const;
    Problem callOfService(const std::vector<std::string>& path, const Call& call, Expectations& expected);
    Problem import(const Call& call, bool isLibrary, Expectations& expected);
    void path(const Call& call, Expectations& expected);
    Problem component(const Call& call, Expectations& expected);
    Problem made(const std::string& name, const std::string& type, Expectations& expected);
    void peers(const std::string& operation, const Call& call, Expectations& expected) const;
    Problem service(const Call& call, Expectations& expected) const;
    Problem require(const Call& call, Expectations& expected) const;
    void change(const Call& call, Expectations& expected) const;
    Problem unload(const Call& call, Expectations& expected);
    Problem description(const Call& call, Expectations& expected) const;
    Problem script(const Call& call, Expectations& expected) const;
    Problem missingScript(const Call& call, const Expectations& expected) const;
    void wiring(const std::vector<NamedArgument>& names, const Call& call, Expectations& expected) const;

    /** What there is to draw of it. */
    void recordFor(const std::string& operation, const Call& call, const Expectations& expected);

    Problem wrongName(const std::vector<NamedArgument>& names, const Call& call, const Expectations& expected) const;
    Problem wrongName(const std::string& given, NamedArgument::Kind kind, const Expectations& expected) const;
    Problem ownMaster(const Call& call, const Expectations& expected) const;
    Problem noService(const std::string& wanted, const std::string& into) const;
    bool isRun() const { return foresight_ == Foresight::Run; }
    bool tells(const Call& call, const Expectations& expected) const;
    /** The component that has that name now, and will have it when the script comes here; null if that is not certain. */
    RTT::TaskContext* known(const std::string& name, const Expectations& expected) const;
    /** Code that was brought in is executed, by a library or a component that is to come. */
    void foreignCode(Expectations& expected) const;
    /** Code of that component is executed. */
    void touch(RTT::TaskContext& component, Expectations& expected) const;
    void touchAll(Expectations& expected) const;
    /** The deployer may be told to do whatever it can. */
    void anyOperation(Expectations& expected) const;

    Session& session_;
    const Foresight foresight_;
    std::set<std::string> failed_;  // components that cannot be made, for a reason that was reported
};

}  // namespace OCL::deploy

#endif
