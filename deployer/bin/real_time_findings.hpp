// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_REAL_TIME_FINDINGS_HPP
#define OROFORGE_DEPLOYER_REAL_TIME_FINDINGS_HPP

#include <diag/diagnostic.hpp>

#include <string>
#include <vector>

namespace OCL::deploy {

/** What --rt-check found about one call. */
struct RealTimeFinding {
    std::string component;
    std::string where;  // "updateHook()"
    std::string verb;   // "allocates memory"
    std::string code;
    std::string function;
    unsigned long count = 0;
    std::vector<oroforge::diag::Note> frames;  // innermost first, "'function()' (file+0x1234)"
    oroforge::diag::Location script;           // the line of the script that called; without file if there is none
};

/**
 * Arranges findings for readers: each is reported at the line of the component that leads to it, if known; frames of
 * the standard library are folded; all findings of a line become one.
 */
std::vector<oroforge::diag::Diagnostic> arranged(const std::vector<RealTimeFinding>& findings);

/** True for a call that the runtime made, not the component. */
bool isOfRuntime(const RealTimeFinding& finding);

/** True if the line of the finding is unknown. */
bool lacksLines(const oroforge::diag::Diagnostic& finding);

}  // namespace OCL::deploy

#endif
