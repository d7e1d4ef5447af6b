// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "call_stack.hpp"

namespace oroforge::cxx {

void CallStack::enter(Frame frame) {
    frame.doubts = findings_.doubts();
    frames_.push_back(std::move(frame));
}

Value CallStack::leave() {
    const Frame frame = std::move(frames_.back());
    frames_.pop_back();
    findings_.settleTo(frame.doubts);
    return frame.result;
}

std::optional<Place> CallStack::find(const clang::ValueDecl& variable) const {
    for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
        const auto local = frame->locals.find(&variable);
        if (local != frame->locals.end()) return local->second;
        if (!frame->lambda) break;
    }
    return std::nullopt;
}

const clang::CXXMethodDecl& CallStack::overriderOf(const clang::CXXMethodDecl& method, const Place& self) const {
    if (!self.isComponent() || type_ == nullptr || !method.isVirtual()) return method;
    const auto* found = method.getCorrespondingMethodInClass(type_, /*MayBeBase=*/true);
    return found == nullptr ? method : *found;
}

/// Stops following code that computes for very long or for ever.
bool CallStack::isTooMuch(clang::SourceLocation at) {
    constexpr unsigned most = 1000000;
    if (++steps_ == most) {
        findings_.noteMore(!findings_.isLate());
        findings_.remark(at, "OC022",
                         "the constructor does more than is followed; what comes from here on is left out");
    }
    return steps_ >= most;
}

bool CallStack::isTooDeep(clang::SourceLocation at) {
    constexpr std::size_t deepest = 64;
    if (frames_.size() < deepest) return false;
    findings_.noteMore(!findings_.isLate());
    findings_.remark(at, "OC022", "functions call each other deeper than is followed; what this one does is left out");
    return true;
}

}  // namespace oroforge::cxx
