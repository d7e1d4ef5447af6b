// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <explain/explanations.hpp>

namespace oroforge {

namespace embedded {
diag::EmbeddedFiles explanationFiles();
}

const diag::Explanations& explain::explanations() {
    static const diag::Explanations all(embedded::explanationFiles());
    return all;
}

}  // namespace oroforge
