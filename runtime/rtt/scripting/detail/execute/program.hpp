// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The programs of scripts.
#ifndef ORO_SCRIPTING_DETAIL_PROGRAM_HPP
#define ORO_SCRIPTING_DETAIL_PROGRAM_HPP

#include <rtt/Service.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/scripting/ProgramInterface.hpp>
#include <rtt/scripting/detail/compile/source_file.hpp>

#include <diag/diagnostic.hpp>

#include <atomic>
#include <memory>
#include <string>

namespace RTT::scripting::detail {

class Program final : public ProgramInterface {
public:
    typedef decltype(Surroundings::roundLimit) RoundLimit;
    /** Where its text stands. */
    struct Text {
        oroforge::diag::FileName file;
        std::string letters;
        ast::Place at;  ///< of the first of them; {0, 0} if that is not known
    };

    Program(std::string name, std::string component, Text text, std::unique_ptr<Code> code, RoundLimit limit,
            std::shared_ptr<const Peers> peers);
    /** Takes it out of its engine. */
    ~Program() override;

    bool execute() override;
    bool isIdle() const override;
    bool pausesInException() const override { return true; }

    const std::string& getName() const override { return name_; }
    bool start() override;
    bool pause() override;
    bool step() override;
    bool stop() override;
    ProgramStatus getStatus() const override;
    int getLineNumber() const override;
    std::string getText() const override { return text_.letters; }
    int getFirstLine() const override { return text_.at.line != 0 ? static_cast<int>(text_.at.line) : 1; }
    std::string getError() const override;

private:
    template <class Rule>
    bool change(Rule rule);
    bool executeOnce();
    bool settle(Process::Outcome outcome);
    void reportFailure();

    const std::string name_, component_;
    const Text text_;
    const std::unique_ptr<const Code> code_;
    const RoundLimit limit_;
    Process process_;               // touched in the engine's thread only, but for pause() and place()
    std::atomic<unsigned> state_;   // a Status, and what is asked for
    mutable os::Mutex error_lock_;  // not taken unless something failed
    std::string error_;
};

/** Compiles; null, with the errors in `*where.sink`, if that fails. `text` are the letters of the item. */
ProgramInterfacePtr makeProgram(const ast::Program& tree, const SourceFile& file, std::string text,
                                const Surroundings& where);

/** The service by which others command a program; not added to the component yet. */
Service::shared_ptr makeProgramService(const ProgramInterfacePtr& program, TaskContext& owner);

}  // namespace RTT::scripting::detail

#endif
