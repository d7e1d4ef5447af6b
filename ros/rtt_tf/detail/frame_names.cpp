// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_tf/detail/frame_names.hpp>

namespace rtt_tf::detail {

std::string bare(const std::string& frame) {
    return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

std::string prefixed(const std::string& prefix, const std::string& frame) {
    if (prefix.empty() || frame.empty() || frame.front() == '/') return bare(frame);
    return prefix + '/' + frame;
}

std::string trimmed(std::string prefix) {
    prefix.erase(0, prefix.find_first_not_of('/'));
    while (!prefix.empty() && prefix.back() == '/') prefix.pop_back();
    return prefix;
}

}  // namespace rtt_tf::detail
