// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <report/explain.hpp>

namespace oroforge {

namespace embedded {
diag::EmbeddedFiles explanationFiles();
}

const diag::Explanations& report::explanations() {
    static const diag::Explanations all(embedded::explanationFiles());
    return all;
}

}  // namespace oroforge
