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

/// Not thread-safe: one sink belongs to one run in one thread. The first kMost errors and warnings are kept. The others
/// are only counted, because a broken file may have millions.
class Sink {
public:
    static constexpr std::size_t kMost = 1000;

    /// The reference stays valid until the next report; use it at once to add notes.
    Diagnostic& error(Location where, std::string code, std::string message);
    Diagnostic& warning(Location where, std::string code, std::string message);
    Diagnostic& note(Location where, std::string message);
    Diagnostic& add(Diagnostic diagnostic);

    bool hadErrors() const { return errors_ != 0; }
    std::size_t errorCount() const { return errors_; }
    std::size_t warningCount() const { return warnings_; }
    bool empty() const { return all_.empty(); }

    /// The kept diagnostics, in the order of reporting, repeats included.
    const std::vector<Diagnostic>& all() const { return all_; }

    /// The kept diagnostics, ordered by place (those without one first) and without repeats. A note at the end says how
    /// many were not kept.
    std::vector<Diagnostic> sorted() const;

private:
    std::vector<Diagnostic> all_;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
    Diagnostic unkept_;
};

}  // namespace oroforge::diag

#endif
