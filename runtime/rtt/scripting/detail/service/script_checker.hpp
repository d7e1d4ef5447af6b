// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Checks a script without executing it.
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_CHECKER_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_CHECKER_HPP

#include <rtt/scripting/check.hpp>
#include <rtt/scripting/detail/compile/find_calls.hpp>
#include <rtt/scripting/detail/service/script_reader.hpp>

#include <boost/shared_ptr.hpp>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RTT::scripting::detail {

/** See check.hpp. */
class ScriptChecker final : private ScriptReader, private NamesToCome {
public:
    ScriptChecker(TaskContext& component, std::shared_ptr<SourceFile> file, CallForecast& forecast,
                  Expectations& expected);
    /** Checks a script that the outer one runs; `certain`: always when the outer one runs. */
    ScriptChecker(ScriptChecker& outer, std::shared_ptr<SourceFile> file, bool certain);
    /** Removes the operations of functions, and the services of programs and state machines. */
    ~ScriptChecker() override;

    /** Returns the diagnostics that are certain. */
    oroforge::diag::Sink check();

private:
    using ScriptReader::take;
    bool take(const ast::Item& item, const ast::StatementPtr& statement) override;
    bool take(const ast::Item& item, const ast::Function& function) override;
    bool take(const ast::Item& item, const ast::Program& program) override;
    bool take(const ast::Item& item, const ast::StateMachine& type) override;
    bool take(const ast::Item& item, const ast::Instance& machine) override;
    bool mayHave(const TaskContext* owner, const std::string& name, bool isFirst) override;
    bool isToCome(const std::string& peer) override;
    bool mayReplace(const std::string& function, bool isOfThis) override;
    bool tellsDoubts() const override { return expected_.doubts; }
    void miss(const std::string& name) override { missed_.insert(name); }
    bool gap();
    /** Notes the names that an item with errors would have defined. */
    void missWhatIsDefinedBy(const ast::Item& item);
    void expectWhatIsDefinedBy(const ast::Item& item);
    /** Adds the operation of a function, for calls by path and for sending. */
    void addOperation(const std::shared_ptr<const FunctionDefinition>& definition, const Activation& pattern);
    /** True if the name is free for a program or state machine. */
    bool isFree(const char* kind, const char* code, const ast::Identifier& name);
    CompileContext unevaluated(const Functions& functions);
    void keepWhatIsCertain(oroforge::diag::Sink& found);
    bool isCertain(const oroforge::diag::Diagnostic& error) const;
    // The effects of calls.
    enum class Made {
        Yes,
        Perhaps,  ///< it uses names that may exist when the script runs
        No        ///< an error was reported
    };
    void foresee(const std::vector<FoundCall>& calls, Made made, oroforge::diag::Sink& found);
    void foresee(const FoundCall& call, oroforge::diag::Sink& found);
    void follow(const std::string& script, bool certain, oroforge::diag::Sink& found);
    bool isWithin(const std::string& script) const;
    bool isCallOfOperation(const FoundCall& call) const;
    bool isOwnOperation(const ast::Name& name) const;

    ScriptChecker* const outer_ = nullptr;  // the script that runs this one
    const bool certain_ = true;             // runs whenever the outermost one runs
    unsigned followed_ = 0;                 // number of scripts that the outermost one follows
    CallForecast& forecast_;
    Expectations& expected_;
    Definitions definitions_;
    std::vector<std::string> services_;
    std::vector<std::pair<boost::shared_ptr<Service>, std::string>> operations_;
    std::map<std::string, const ast::Block*> bodies_;  // of functions and programs of this script
    std::set<const ast::Block*> entered_;              // bodies that were entered
    std::set<std::string> replaced_;                   // functions defined by scripts that this one runs
    std::set<std::string> missed_;                     // names that the script would have declared
    bool incomplete_ = false;                          // something was not compiled
};

}  // namespace RTT::scripting::detail

#endif
