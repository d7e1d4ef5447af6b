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
    typedef decltype(CompileContext::roundLimit) RoundLimit;
    /** The text and its place. */
    struct Text {
        oroforge::diag::FileName file;
        std::string letters;
        ast::Place at;  ///< its beginning; {0, 0} if unknown
    };

    Program(std::string name, std::string component, Text text, std::unique_ptr<Code> code, RoundLimit limit,
            std::shared_ptr<const Peers> peers);
    /** Removes it from its engine. */
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
    Process process_;               // used only in the engine's thread, except for pause() and place()
    std::atomic<unsigned> state_;   // a Status and requests
    mutable os::Mutex error_lock_;  // locked only after a failure
    std::string error_;
};

/** Compiles a program from `text`, the source of the item. Reports errors to `*where.sink` and then returns null. */
ProgramInterfacePtr makeProgram(const ast::Program& tree, const SourceFile& file, std::string text,
                                const CompileContext& where);

/** The service with the commands of a program; not added to the component. */
Service::shared_ptr makeProgramService(const ProgramInterfacePtr& program, TaskContext& owner);

}  // namespace RTT::scripting::detail

#endif
