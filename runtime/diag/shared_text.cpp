// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/shared_text.hpp>

namespace oroforge::diag {

const std::string& SharedText::str() const {
    static const std::string nothing;
    return shared_ ? shared_->text : nothing;
}

}  // namespace oroforge::diag
