// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The effects of calls of the deployer's operations, for scripts that are checked.
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
    Run,   ///< for a script that runs afterwards: creates no components, and reports only certain failures
    Check  ///< for a script that does not run: creates the components, to know their operations; reports what will fail
};

/** An argument that is a literal text; null for others. */
inline const std::string* textOf(const RTT::scripting::ForeseenCall& call, std::size_t argument) {
    return argument < call.texts.size() ? call.texts[argument] : nullptr;
}

/** Does the imports that a script is certain to do; for a script that runs afterwards, only those at its beginning. */
class ScriptForecast final : public RTT::scripting::CallForecast {
public:
    ScriptForecast(Session& session, Foresight foresight) : session_(session), foresight_(foresight) {}

    /** Expects what running components may do at any time. */
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
    Problem chain(const Call& call, Expectations& expected);
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

    /** Records what the graph shows of the call. */
    void recordFor(const std::string& operation, const Call& call, const Expectations& expected);

    Problem wrongName(const std::vector<NamedArgument>& names, const Call& call, const Expectations& expected) const;
    Problem wrongName(const std::string& given, NamedArgument::Kind kind, const Expectations& expected) const;
    Problem ownMaster(const Call& call, const Expectations& expected) const;
    Problem noService(const std::string& wanted, const std::string& into) const;
    bool isRun() const { return foresight_ == Foresight::Run; }
    bool tells(const Call& call, const Expectations& expected) const;
    /** The component that has the name now and certainly when the script reaches the call; otherwise null. */
    RTT::TaskContext* known(const std::string& name, const Expectations& expected) const;
    /** Expects the effects of unknown code, of a library or of a component that does not exist yet. */
    void foreignCode(Expectations& expected) const;
    /** Expects the effects of code of that component. */
    void touch(RTT::TaskContext& component, Expectations& expected) const;
    void touchAll(Expectations& expected) const;
    /** Expects that any operation of the deployer may be called. */
    void anyOperation(Expectations& expected) const;

    Session& session_;
    const Foresight foresight_;
    std::set<std::string> failed_;  // components that cannot be created, for a reason that was reported
};

}  // namespace OCL::deploy

#endif
