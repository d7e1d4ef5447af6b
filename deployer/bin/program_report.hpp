// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The option --format: a document, for other programs, of everything that is reported.
#ifndef OROFORGE_DEPLOYER_PROGRAM_REPORT_HPP
#define OROFORGE_DEPLOYER_PROGRAM_REPORT_HPP

#include <diag/sink.hpp>
#include <report/report.hpp>

#include <string>

namespace OCL::deploy {

/** Reports for a program: prints diagnostics as text at once, or keeps them for a document. One per process. Any thread
    may call its functions unless they say otherwise. */
class ProgramReport {
public:
    /** `program`: its name in messages. */
    ProgramReport(std::string program, oroforge::report::Format format);
    ~ProgramReport();
    ProgramReport(const ProgramReport&) = delete;
    ProgramReport& operator=(const ProgramReport&) = delete;

    const std::string& program() const { return program_; }
    bool isText() const { return format_ == oroforge::report::Format::Text; }
    /** Keeps diagnostics off the terminal and the log's console, because they are in the document. */
    void onlyInDocument() { alone_ = !isText(); }
    /** Reserves standard output for the document: other output to it goes to standard error from now on. */
    void reserveOutput();

    /** Reports an error of the program itself, without a code. `where` is a file, or empty for the command line. */
    void error(const std::string& where, const std::string& message, const std::string& hint = "");
    void warning(const std::string& message);
    /** Reports a diagnostic, as the runtime does for files. */
    void add(oroforge::diag::Diagnostic diagnostic);
    std::size_t errorCount() const;

    /** Writes the document, if one is wanted. Returns `status`, or the exit status of a failure if it cannot be
        written. */
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
