// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_code.hpp>

namespace RTT::scripting::detail {

CodeRoutine::CodeRoutine(std::unique_ptr<const Code> code, const CompileContext& where, Pace pace)
    : code_(std::move(code)),
      file_(where.file),
      limit_(where.roundLimit),
      pace_(pace),
      first_line_(code_->placeOf(code_->begin()).line),
      process_(*code_) {
    process_.watch(where.peers);
}

Routine::Outcome CodeRoutine::run() {
    limit();
    return pace_ == Pace::AtOnce ? process_.runToEnd() : process_.run();
}

Routine::Outcome CodeRoutine::runStatement() {
    limit();
    return process_.runStatement();
}

unsigned CodeRoutine::line() const { return process_.started() ? process_.line() : first_line_; }

oroforge::diag::Location CodeRoutine::where() const {
    if (process_.failedCall()) return process_.failedCall()->place().where;
    const ast::Place place = process_.place();
    return {file_, place.line, place.column};
}

CodeGuard::CodeGuard(std::unique_ptr<const Code> code, const bool* result, const CompileContext& where)
    : routine_(std::move(code), where, CodeRoutine::Pace::AtOnce), result_(result) {}

Guard::Truth CodeGuard::check(unsigned) {
    if (failed_) routine_.restart();
    failed_ = routine_.run() != Routine::Outcome::Finished;
    if (failed_) return Truth::Failed;
    return *result_ ? Truth::Yes : Truth::No;
}

RoutinePtr makeRoutine(std::unique_ptr<Code> code, const CompileContext& where, CodeRoutine::Pace pace) {
    if (!code || code->statementCount() == 0) return nullptr;
    return std::make_unique<CodeRoutine>(std::move(code), where, pace);
}

RoutinePtr makeProgram(const std::unique_ptr<ast::Block>& block, const std::string& name, const Scope& scope,
                       const CompileContext& where) {
    if (!block) return nullptr;
    return makeRoutine(Compiler(where).program(*block, name, scope), where, CodeRoutine::Pace::StepByStep);
}

GuardPtr makeGuard(const ast::Expression& condition, const Scope& scope, const CompileContext& where) {
    const bool* result = nullptr;
    auto code = Compiler(where).condition(condition, scope, result);
    if (!code) return nullptr;
    return std::make_unique<CodeGuard>(std::move(code), result, where);
}

PortReader::PortReader(const base::InputPortInterface& port, base::DataSourceBase::shared_ptr sample)
    : name_(port.getName()), port_(port), sample_(std::move(sample)) {}

bool PortReader::hasNewData(unsigned round) {
    if (round_ != round) status_ = port_.read(sample_->getRawPointer());
    round_ = round;
    return status_ == NewData;
}

PortGuard::PortGuard(std::shared_ptr<PortReader> reader, ActionPtr assign, oroforge::diag::Location where)
    : reader_(std::move(reader)), assign_(std::move(assign)), where_(std::move(where)) {}

Guard::Truth PortGuard::check(unsigned round) {
    if (!reader_->hasNewData(round)) return Truth::No;
    if (!assign_) return Truth::Yes;
    assign_->readArguments();
    return assign_->execute() ? Truth::Yes : Truth::Failed;
}

std::string PortGuard::failure() const {
    return "the sample of port '" + reader_->name() + "' cannot be assigned to its variable";
}

}  // namespace RTT::scripting::detail
