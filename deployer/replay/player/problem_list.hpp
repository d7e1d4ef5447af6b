// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_PROBLEM_LIST_HPP
#define OROFORGE_REPLAY_PROBLEM_LIST_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace OCL::replay {

/** Texts in the order in which they came first. A damaged file may have millions of problems, so only the first ones
    are kept. */
class ProblemList {
public:
    /** Those of one kind are counted after the first. */
    void add(const std::string& kind, const std::string& text) {
        const auto found = places_.find(kind);
        if (found != places_.end()) {
            ++list_[found->second].more;
        } else if (list_.size() == kMost) {
            ++others_;
        } else {
            places_.emplace(kind, list_.size());
            list_.push_back({text, 0});
        }
    }
    void add(const std::string& text) { add(text, text); }

    std::vector<std::string> all() const {
        std::vector<std::string> result;
        for (const One& one : list_)
            result.push_back(one.more == 0 ? one.text : one.text + " (and " + std::to_string(one.more) + " more)");
        if (others_ != 0) result.push_back("and " + std::to_string(others_) + " other problems");
        return result;
    }
    std::size_t size() const { return list_.size(); }

private:
    static constexpr std::size_t kMost = 1000;
    struct One {
        std::string text;
        std::uint64_t more;
    };
    std::vector<One> list_;
    std::map<std::string, std::size_t> places_;
    std::uint64_t others_ = 0;
};

}  // namespace OCL::replay

#endif
