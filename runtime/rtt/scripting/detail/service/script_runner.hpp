// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Runs the text of a script: parses it, then takes one item after the other.
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_RUNNER_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_RUNNER_HPP

#include <rtt/scripting/detail/service/script_reader.hpp>
#include <rtt/scripting/detail/service/script_syntax.hpp>

#include <string>
#include <vector>

namespace RTT::scripting {

class ScriptingService;

namespace detail {

/** Statements see the variables of the script of the same component that runs this one, in the same thread. */
class ScriptRunner final : private ScriptReader {
public:
    /** `name` stands for the text in messages. The service has an owner. */
    ScriptRunner(ScriptingService& service, oroforge::diag::FileName name, std::string text);
    ~ScriptRunner() override;

    /** True if all of it was executed; otherwise the log says why it was not. */
    bool run(Contents contents);
    /** Of those in the log, with its place; empty if there was none. */
    const std::string& firstError() const { return first_error_; }

    /** Where that file is: as it is called or, if there is none, beside the script that this thread is running. */
    static std::string locate(const std::string& file);

    /** Scripts went too deep: all of them end, which was told once. */
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
    /** The programs and state machines of this text. */
    void unload();
    void checkContents(Contents contents);
    bool isFree(const char* kind, const char* code, const ast::Identifier& name);
    /** With the step budget. */
    Surroundings limited(const Functions& functions);
    /** Into the log. */
    void report();

    ScriptingService& service_;
    const ScriptRunner* const outer_;               // the one that this thread is in the midst of
    const unsigned depth_;                          // how many of those there are
    std::vector<std::string> programs_, machines_;  // loaded so far
    std::string first_error_;
};

}  // namespace detail
}  // namespace RTT::scripting

#endif
