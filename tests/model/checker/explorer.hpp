// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which step comes next: depth-first search with dynamic partial-order reduction and sleep sets.
#ifndef OROFORGE_MODEL_EXPLORER_HPP
#define OROFORGE_MODEL_EXPLORER_HPP

#include <model/checker/internal.hpp>

#include <cstdint>
#include <vector>

namespace model {

class Explorer {
public:
    typedef std::uint8_t Set;  // of threads
    typedef std::array<Step, kThreads> Pending;

    explicit Explorer(bool reduction) : reduction_(reduction) {}
    /** To the first step of the same or the next run. */
    void rewind();
    /** The thread that takes the next step, of those `enabled`; -1 if all that begins so was tried before. */
    int next(Set enabled, const Pending& pending, unsigned preferred);
    /** A choice within the step that next() gave. */
    unsigned choose(unsigned count);
    /** False if everything was tried. */
    bool advance();
    std::size_t depth() const { return depth_; }

private:
    struct Node {
        Set enabled, sleep, done, backtrack;
        std::uint8_t chosen;
        bool analysed;
        unsigned choice, choices;
        Pending pending;
        Clock before;  // by dependence: of each thread, how many steps of the run come before and with this one
    };
    bool dependent(const Step& a, const Step& b) const;
    void analyse(std::size_t at);
    void reverse(std::size_t early, std::size_t late);

    bool reduction_;
    std::vector<Node> path_;
    std::size_t depth_ = 0;
    std::array<Clock, kThreads> last_{};  // Node::before of each thread's last step
};

}  // namespace model

#endif
