// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/deployment/deployed_texts.hpp>

#include <algorithm>
#include <cstddef>
#include <mutex>

namespace RTT::plugin {
namespace {

constexpr std::size_t kMostBytes = std::size_t(1) << 20;
constexpr std::size_t kMostFiles = 1000;

struct Texts {
    std::mutex mutex;
    std::vector<DeployedText> all;
    std::size_t size = 0;
};

Texts& texts() {
    static Texts& all = *new Texts;  // components may outlive static objects
    return all;
}

}  // namespace

void noteDeployedText(const std::string& file, const std::string& text) {
    Texts& its = texts();
    const std::lock_guard<std::mutex> lock(its.mutex);
    auto found =
        std::find_if(its.all.begin(), its.all.end(), [&](const DeployedText& one) { return one.file == file; });
    if (found == its.all.end()) {
        if (its.all.size() == kMostFiles) return;
        found = its.all.insert(its.all.end(), {file, ""});
    }
    its.size -= found->text.size();
    const bool fits = text.size() <= kMostBytes - std::min(its.size, kMostBytes);
    found->text = fits ? text : "(" + std::to_string(text.size()) + " bytes, which are too many)";
    its.size += found->text.size();
}

std::vector<DeployedText> deployedTexts() {
    Texts& its = texts();
    const std::lock_guard<std::mutex> lock(its.mutex);
    return its.all;
}

}  // namespace RTT::plugin
