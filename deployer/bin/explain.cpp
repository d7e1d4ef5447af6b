// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "explain.hpp"

#include <diag/explain.hpp>
#include <diag/print.hpp>

#include <iostream>

namespace oroforge::embedded {
diag::EmbeddedFiles codesOfDeployer();
}

namespace OCL::deploy {

namespace diag = oroforge::diag;

bool explain(const std::vector<std::string>& codes, const std::string& program) {
    diag::Sink sink;
    const diag::Explanations all(oroforge::embedded::codesOfDeployer());
    all.print(codes, {program, ""}, std::cout, sink);
    diag::print(std::cerr, sink);
    return !sink.hadErrors();
}

}  // namespace OCL::deploy
