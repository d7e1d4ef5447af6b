// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Runs a script: parses it, then handles one item after another.
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_RUNNER_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_RUNNER_HPP

#include <rtt/scripting/detail/service/script_reader.hpp>
#include <rtt/scripting/script_syntax.hpp>

#include <string>
#include <vector>

namespace RTT::scripting {

class ScriptingService;

namespace detail {

/** Statements see the variables of the script that runs this one, if it is in the same component and thread. */
class ScriptRunner final : private ScriptReader {
public:
    /** Messages call the text `name`. The service must have an owner. */
    ScriptRunner(ScriptingService& service, oroforge::diag::FileName name, std::string text);
    ~ScriptRunner() override;

    /** True if all of it was executed; otherwise logs the reason. */
    bool run(Contents contents);
    /** The first error in the log, with its place; empty if there was none. */
    const std::string& firstError() const { return first_error_; }

    /** The path of a file: as given or, if it does not exist, beside the script that this thread is running. */
    static std::string locate(const std::string& file);

    /** True if scripts were nested too deeply; all of them end, which was reported once. */
    static bool isUnwinding();

private:
    /** The script of that service that this thread is running; null if there is none. */
    static SourceFilePtr runningIn(const ScriptingService& service);
    using ScriptReader::take;
    bool take(const ast::Item& item, const ast::StatementPtr& statement) override;
    bool take(const ast::Item& item, const ast::Function& function) override;
    bool take(const ast::Item& item, const ast::Program& program) override;
    bool take(const ast::Item& item, const ast::StateMachine& type) override;
    bool take(const ast::Item& item, const ast::Instance& machine) override;
    bool checkDepth();
    /** Unloads the programs and state machines of this text. */
    void unload();
    void checkContents(Contents contents);
    bool isFree(const char* kind, const char* code, const ast::Identifier& name);
    /** The context with the step budget. */
    CompileContext limited(const Functions& functions);
    /** Logs the diagnostics. */
    void report();

    ScriptingService& service_;
    const ScriptRunner* const outer_;               // the script that this thread was running
    const unsigned depth_;                          // the number of scripts around this one
    std::vector<std::string> programs_, machines_;  // loaded so far
    std::string first_error_;
};

}  // namespace detail
}  // namespace RTT::scripting

#endif
