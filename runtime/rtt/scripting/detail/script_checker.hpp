// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Looks through a script without executing it.
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_CHECKER_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_CHECKER_HPP

#include <rtt/scripting/detail/script_reader.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace scripting {
namespace detail {

/** See check.hpp. */
class ScriptChecker final : private ScriptReader {
public:
    ScriptChecker(TaskContext& component, std::shared_ptr<SourceFile> file);
    /** Removes the services of programs and state machines. */
    ~ScriptChecker() override;

    /** All that is certain. */
    oroforge::diag::Sink check();

private:
    using ScriptReader::take;
    bool take(const ast::Item& item, const ast::StatementPtr& statement) override;
    bool take(const ast::Item& item, const ast::Function& function) override;
    bool take(const ast::Item& item, const ast::Program& program) override;
    bool take(const ast::Item& item, const ast::StateMachine& type) override;
    bool take(const ast::Item& item, const ast::Instance& machine) override;
    /** For a program or a state machine. */
    bool isFree(const char* kind, const char* code, const ast::Identifier& name);
    Surroundings unevaluated(const Functions& functions);
    void keepWhatIsCertain(oroforge::diag::Sink& found);

    Definitions definitions_;
    std::vector<std::string> services_;
    bool names_are_known_ = true;  // no statement has called anything so far
};

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
