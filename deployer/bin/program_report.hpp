// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The option --format: a document for programs of all that is reported.
#ifndef OROFORGE_DEPLOYER_PROGRAM_REPORT_HPP
#define OROFORGE_DEPLOYER_PROGRAM_REPORT_HPP

#include <diag/sink.hpp>
#include <report/report.hpp>

#include <string>

namespace OCL::deploy {

/** What a program reports, as text at once, or kept for a document. One per process. Any thread, unless it says otherwise. */
class ProgramReport {
public:
    /** `program`: its name in messages. */
    ProgramReport(std::string program, oroforge::report::Format format);
    ~ProgramReport();
    ProgramReport(const ProgramReport&) = delete;
    ProgramReport& operator=(const ProgramReport&) = delete;

    const std::string& program() const { return program_; }
    bool isText() const { return format_ == oroforge::report::Format::Text; }
    /** Keeps diagnostics off the terminal and the console of the log: they are in the document. */
    void onlyInDocument() { alone_ = !isText(); }
    /** Gives the standard output to the document: what anybody writes there from now on goes to standard error. */
    void reserveOutput();

    /** A diagnostic of the program itself, without a code. `where`: a file; empty: the command line. */
    void error(const std::string& where, const std::string& message, const std::string& hint = "");
    void warning(const std::string& message);
    /** As all parts of the runtime do with what they report of files. */
    void add(oroforge::diag::Diagnostic diagnostic);
    std::size_t errorCount() const;

    /** Writes the document, if one is wanted. Returns the exit status: `status`, or a failure if it cannot be written. */
    int finish(int status);

private:
    static bool take(const oroforge::diag::Sink& sink);

    const std::string program_;
    const oroforge::report::Format format_;
    bool alone_ = false;
    int output_;  // descriptor of the document
};

}  // namespace OCL::deploy

#endif
