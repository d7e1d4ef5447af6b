// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/checker/explorer.hpp>

namespace model {

namespace {
Explorer::Set only(unsigned thread) { return static_cast<Explorer::Set>(1u << thread); }
bool has(Explorer::Set set, unsigned thread) { return set >> thread & 1; }

/** Whether two dependent steps could also have come in the other order. */
bool exchangeable(const Step& first, const Step& second) {
    return first.kind != Step::Unlock && second.kind != Step::Resume;
}
}  // namespace

void Explorer::rewind() {
    depth_ = 0;
    last_.fill(Clock());
}

bool Explorer::dependent(const Step& a, const Step& b) const {
    if (a.kind == Step::Begin || b.kind == Step::Begin) return false;
    if (!reduction_) return true;
    const auto local = [](const Step& s) {
        return s.kind == Step::Begin || s.kind == Step::Yield || s.kind == Step::Resume;
    };
    const auto reads = [](const Step& s) { return s.kind == Step::Load || s.kind == Step::Wait; };
    if (a.kind == Step::Barrier) return !local(b) && b.kind != Step::Barrier;
    if (b.kind == Step::Barrier) return !local(a);
    if (a.object != b.object || a.object == kNever) return false;
    if (a.kind == Step::Wait && b.kind == Step::Wait) return true;  // they queue
    if (reads(a) && reads(b)) return false;
    if (a.kind == Step::Resume || b.kind == Step::Resume) return a.kind == Step::Wake || b.kind == Step::Wake;
    if (a.kind == Step::Wake || b.kind == Step::Wake)  // does not look at the word
        return a.kind == b.kind || a.kind == Step::Wait || b.kind == Step::Wait;
    return true;
}

int Explorer::next(Set enabled, const Pending& pending, unsigned preferred) {
    if (depth_ == path_.size()) {
        Node node{enabled, 0, 0, 0, 0, false, 0, 1, pending, {}};
        if (depth_ > 0) {
            const Node& parent = path_[depth_ - 1];
            const Step& taken = parent.pending[parent.chosen];
            for (unsigned t = 0; t < kThreads; ++t)
                if (t != parent.chosen && has(parent.sleep | parent.done, t) && !dependent(parent.pending[t], taken))
                    node.sleep |= only(t);
        }
        const Set awake = enabled & ~node.sleep;
        if (!awake) return -1;
        unsigned chosen = preferred;
        if (!has(awake, preferred))
            for (chosen = 0; !has(awake, chosen);) ++chosen;
        node.chosen = static_cast<std::uint8_t>(chosen);
        node.backtrack = only(chosen);
        path_.push_back(node);
    }
    Node& node = path_[depth_];
    if (!node.analysed) analyse(depth_);
    last_[node.chosen] = node.before;
    ++depth_;
    return node.chosen;
}

// Every earlier step that is dependent on this one and not ordered with it by others in between could have come after it.
void Explorer::analyse(std::size_t at) {
    Node& node = path_[at];
    node.analysed = true;
    const unsigned self = node.chosen;
    const Step& step = node.pending[self];
    Clock known = last_[self], all = known;
    std::vector<std::size_t> races;
    for (std::size_t i = at; i-- > 0;) {
        const Node& earlier = path_[i];
        const unsigned other = earlier.chosen;
        const Step& taken = earlier.pending[other];
        if (other == self || !dependent(taken, step) || known.at[other] > i) continue;
        if (exchangeable(taken, step)) {
            races.push_back(i);
            known.join(earlier.before);
        }
        all.join(earlier.before);
    }
    all.join(known);
    all.at[self] = static_cast<std::uint32_t>(at + 1);
    node.before = all;
    for (const std::size_t i : races) reverse(i, at);
}

// For `late` to come before `early`, so must the steps in between that do not depend on `early`. One of those that can be
// the first of them has to be tried in place of `early` (source sets; Abdulla, Aronis, Jonsson and Sagonas).
void Explorer::reverse(std::size_t early, std::size_t late) {
    const auto isBefore = [this](std::size_t a, std::size_t b) { return path_[b].before.at[path_[a].chosen] > a; };
    std::vector<std::size_t> moved;
    Set first = 0;
    for (std::size_t k = early + 1; k <= late; ++k) {
        if (k != late && isBefore(early, k)) continue;
        bool isFirst = true;
        for (const std::size_t other : moved) isFirst = isFirst && !isBefore(other, k);
        if (isFirst) first |= only(path_[k].chosen);
        moved.push_back(k);
    }
    Node& node = path_[early];
    if (first & node.backtrack) return;
    first &= node.enabled;
    if (!first) {
        node.backtrack |= node.enabled;
        return;
    }
    unsigned chosen = path_[late].chosen;
    if (!has(first, chosen))
        for (chosen = 0; !has(first, chosen);) ++chosen;
    node.backtrack |= only(chosen);
}

unsigned Explorer::choose(unsigned count) {
    if (depth_ == 0) return 0;  // before the threads begin
    Node& node = path_[depth_ - 1];
    node.choices = count;
    return node.choice;
}

bool Explorer::advance() {
    while (!path_.empty()) {
        Node& node = path_.back();
        if (++node.choice < node.choices) return true;
        node.done |= only(node.chosen);
        const Set left = node.backtrack & ~node.done & ~node.sleep;
        if (left) {
            unsigned chosen = 0;
            while (!has(left, chosen)) ++chosen;
            node.chosen = static_cast<std::uint8_t>(chosen);
            node.choice = 0;
            node.choices = 1;
            node.analysed = false;
            return true;
        }
        path_.pop_back();
    }
    return false;
}

}  // namespace model
