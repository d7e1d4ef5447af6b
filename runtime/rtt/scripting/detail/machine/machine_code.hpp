// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Programs, conditions and ports of a state machine.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_CODE_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_CODE_HPP

#include <rtt/FlowStatus.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/flow/port_sources.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>
#include <rtt/scripting/detail/machine/machine_model.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

typedef decltype(CompileContext::roundLimit) RoundLimit;

class CodeRoutine final : public Routine {
public:
    /** AtOnce: run() continues after yields, see Process::runToEnd(). */
    enum class Pace { StepByStep, AtOnce };
    CodeRoutine(std::unique_ptr<const Code> code, const CompileContext& where, Pace pace = Pace::StepByStep);
    void restart() override { process_.restart(); }
    Outcome run() override;
    Outcome runStatement() override;
    bool started() const override { return process_.started(); }
    unsigned line() const override;
    oroforge::diag::Location where() const override;
    std::string failure() const override { return process_.message(); }

private:
    void limit() { process_.setRoundLimit(limit_ ? limit_->rvalue() : 0); }

    const std::unique_ptr<const Code> code_;
    const oroforge::diag::FileName file_;
    const RoundLimit limit_;
    const Pace pace_;
    const unsigned first_line_;
    Process process_;
};

class CodeGuard final : public Guard {
public:
    /** The code stores its result at `result`. */
    CodeGuard(std::unique_ptr<const Code> code, const bool* result, const CompileContext& where);
    Truth check(unsigned round) override;
    oroforge::diag::Location where() const override { return routine_.where(); }
    std::string failure() const override { return routine_.failure(); }

private:
    CodeRoutine routine_;
    const bool* const result_;
    bool failed_ = false;
};

/** A routine for the code; null if there is nothing to execute. */
RoutinePtr makeRoutine(std::unique_ptr<Code> code, const CompileContext& where, CodeRoutine::Pace pace);
// They are null if there is nothing to compile, or an error, which is reported.
RoutinePtr makeProgram(const std::unique_ptr<ast::Block>& block, const std::string& name, const Scope& scope,
                       const CompileContext& where);
GuardPtr makeGuard(const ast::Expression& condition, const Scope& scope, const CompileContext& where);

/** Reads a port for transitions, once in a round. If it outlives the port, there is no more data. */
class PortReader {
public:
    /** `sample` is storage of the port's type. */
    PortReader(const base::InputPortInterface& port, base::DataSourceBase::shared_ptr sample);
    bool hasNewData(unsigned round);
    const std::string& name() const { return name_; }
    const base::DataSourceBase::shared_ptr& sample() const { return sample_; }

private:
    const std::string name_;
    const internal::PortLink port_;
    const base::DataSourceBase::shared_ptr sample_;
    FlowStatus status_ = NoData;
    unsigned round_ = 0;
};

typedef std::unique_ptr<base::ActionInterface> ActionPtr;

class PortGuard final : public Guard {
public:
    /** `assign`, which may be null, copies the sample to a variable of the script. */
    PortGuard(std::shared_ptr<PortReader> reader, ActionPtr assign, oroforge::diag::Location where);
    Truth check(unsigned round) override;
    oroforge::diag::Location where() const override { return where_; }
    std::string failure() const override;

private:
    const std::shared_ptr<PortReader> reader_;
    const ActionPtr assign_;
    const oroforge::diag::Location where_;
};

}  // namespace RTT::scripting::detail

#endif
