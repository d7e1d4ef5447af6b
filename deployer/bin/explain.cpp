// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "explain.hpp"

#include "program_report.hpp"

#include <diag/print.hpp>

#include <cctype>
#include <iostream>
#include <set>

namespace oroforge::embedded {
diag::EmbeddedFiles codesOfDeployer();
}

namespace OCL::deploy {

namespace diag = oroforge::diag;

namespace {

/** The letters at the beginning of a code. */
std::string kindOf(const std::string& code) {
    std::string kind;
    for (const char letter : code) {
        if (!std::isalpha(static_cast<unsigned char>(letter))) break;
        kind += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    }
    return kind;
}

/** True for codes of the programs that make packages. */
bool isOfGenerators(const std::string& code) {
    static const std::set<std::string> kinds = {"EMIT", "OC", "OM", "TK"};
    return kinds.count(kindOf(code)) != 0;
}

}  // namespace

const diag::Explanations& explanations() {
    static const diag::Explanations all(oroforge::embedded::codesOfDeployer());
    return all;
}

bool explain(const std::vector<std::string>& codes, const std::string& program, ProgramReport& report) {
    diag::Sink sink;
    std::vector<std::string> own;
    for (const std::string& code : codes) {
        if (isOfGenerators(code))
            sink.error({program, 0, 0}, "", "code '" + code + "' is not of this program")
                .hint("typegen --explain " + code + " and orocreate-pkg --explain " + code + " explain it");
        else
            own.push_back(code);
    }
    if (codes.empty() || !own.empty()) explanations().print(own, {program, ""}, std::cout, sink);
    if (report.isText()) diag::print(std::cerr, sink);
    for (const diag::Diagnostic& diagnostic : sink.all()) report.add(diagnostic);
    return diag::arrived(std::cout, std::cerr, program) && !sink.hadErrors();
}

}  // namespace OCL::deploy
