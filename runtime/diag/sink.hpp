// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Collects diagnostics, so that one run reports everything it can find.
#ifndef OROFORGE_DIAG_SINK_HPP
#define OROFORGE_DIAG_SINK_HPP

#include <cstddef>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>

namespace oroforge::diag {

/// Not thread-safe: one sink belongs to one run in one thread.
class Sink {
public:
    /// The reference stays valid until the next report; use it at once to add notes.
    Diagnostic& error(Location where, std::string code, std::string message);
    Diagnostic& warning(Location where, std::string code, std::string message);
    Diagnostic& note(Location where, std::string message);
    Diagnostic& add(Diagnostic diagnostic);

    bool hadErrors() const { return errors_ != 0; }
    std::size_t errorCount() const { return errors_; }
    std::size_t warningCount() const { return warnings_; }
    bool empty() const { return all_.empty(); }

    /// In the order of reporting, repeats included.
    const std::vector<Diagnostic>& all() const { return all_; }

    /// Ordered by place (those without a place first) and without repeats.
    std::vector<Diagnostic> sorted() const;

private:
    std::vector<Diagnostic> all_;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
};

}  // namespace oroforge::diag

#endif
