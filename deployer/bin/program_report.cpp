// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "program_report.hpp"

#include "../deployment/report.hpp"
#include "deployer_options.hpp"
#include "explain.hpp"

#include <diag/print.hpp>
#include <rtt/internal/diagnostic_taker.hpp>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <mutex>
#include <set>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace OCL::deploy {

namespace diag = oroforge::diag;
namespace documents = oroforge::report;  // report() is a function here

namespace {

constexpr int kFailure = 255;
/** The number of diagnostics whose repeats are recognised: a program that runs for months may report one each
    second. */
constexpr std::size_t kMost = 2 * diag::Sink::kMost;

struct Kept {
    std::mutex mutex;
    diag::Sink sink;
    std::set<std::string> known;
};

/** Never destroyed: threads of components may report until the process ends. */
Kept& kept() {
    static Kept& all = *new Kept;
    return all;
}

ProgramReport* current = nullptr;

/** "deployer" of "deployer-gnulinux": documents do not depend on the target. */
std::string plainName(const std::string& program) {
    const std::string suffix = "-" OROCOS_TARGET_NAME;
    const std::size_t length = program.size() - suffix.size();
    const bool has = program.size() > suffix.size() && program.compare(length, std::string::npos, suffix) == 0;
    return has ? program.substr(0, length) : program;
}

bool writeAll(int descriptor, const std::string& text) {
    for (std::size_t done = 0; done != text.size();) {
        const ssize_t size = write(descriptor, text.data() + done, text.size() - done);
        if (size < 0 && errno != EINTR) return false;
        if (size > 0) done += static_cast<std::size_t>(size);
    }
    return true;
}

}  // namespace

ProgramReport::ProgramReport(std::string program, documents::Format format)
    : program_(std::move(program)), format_(format), output_(STDOUT_FILENO) {
    current = this;
    if (!isText()) RTT::internal::setDiagnosticTaker(&ProgramReport::take);
}

ProgramReport::~ProgramReport() { RTT::internal::setDiagnosticTaker(nullptr); }

void ProgramReport::reserveOutput() {
    if (isText()) return;
    std::cout.flush();
    output_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    dup2(STDERR_FILENO, STDOUT_FILENO);
}

void ProgramReport::error(const std::string& where, const std::string& message, const std::string& hint) {
    if (isText() || !alone_)
        std::cerr << (where.empty() ? program_ : where) << ": error: " << message << "\n"
                  << hint << (hint.empty() ? "" : "\n");
    diag::Diagnostic made;
    made.where.file = where;
    made.message = message;
    if (!hint.empty()) made.hint(hint);
    add(made);
}

void ProgramReport::warning(const std::string& message) {
    if (isText() || !alone_) std::cerr << program_ << ": warning: " << message << "\n";
    add({diag::Severity::Warning, "", {}, message, {}, {}});
}

void ProgramReport::add(diag::Diagnostic diagnostic) {
    if (isText()) return;
    // The name of the program is not a file.
    if (diagnostic.where.line == 0 && diagnostic.where.file.str() == program_) diagnostic.where = {};
    Kept& all = kept();
    const std::lock_guard<std::mutex> lock(all.mutex);
    if (all.known.size() == kMost || all.known.insert(diag::toString(diagnostic)).second)
        all.sink.add(std::move(diagnostic));
}

bool ProgramReport::take(const diag::Sink& sink) {
    for (const diag::Diagnostic& diagnostic : sink.sorted()) current->add(diagnostic);
    if (current->alone_) logToFile(sink);
    return current->alone_;
}

std::size_t ProgramReport::errorCount() const {
    Kept& all = kept();
    const std::lock_guard<std::mutex> lock(all.mutex);
    return all.sink.errorCount();
}

int ProgramReport::finish(int status) {
    if (isText()) return status;
    if (status != 0 && errorCount() == 0)
        error("", "the program failed for a reason that is in no file",
              "what it wrote to standard error, and the log, say more");
    Kept& all = kept();
    const std::lock_guard<std::mutex> lock(all.mutex);
    const std::string name = plainName(program_);
    const documents::Tool tool{name, programVersion(), &explanations(), name, status};
    const bool isJson = format_ == documents::Format::Json;
    if (writeAll(output_, isJson ? documents::jsonReport(tool, all.sink) : documents::sarifReport(tool, all.sink)))
        return status;
    std::cerr << program_ << ": error: the report cannot be written: " << std::strerror(errno) << "\n";
    return kFailure;
}

}  // namespace OCL::deploy
