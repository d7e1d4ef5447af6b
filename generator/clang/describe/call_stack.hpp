// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The functions that are being followed, and the limits to that.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_CALL_STACK_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_CALL_STACK_HPP

#include <map>
#include <optional>
#include <vector>

#include "component_state.hpp"
#include "findings.hpp"

namespace oroforge::cxx {

class CallStack {
public:
    struct Frame {
        Place self;
        std::map<const clang::ValueDecl*, Place> locals;
        Value result;
        bool lambda = false;  ///< uses the locals of the frames below
        std::size_t doubts = 0;
    };

    explicit CallStack(Findings& findings) : findings_(findings) {}

    void enter(Frame frame);
    /// A function's doubts end with it.
    Value leave();
    Frame& top() { return frames_.back(); }
    std::optional<Place> find(const clang::ValueDecl& variable) const;

    /// Sets the class whose constructor runs, which gets virtual calls. Returns the previous one.
    const clang::CXXRecordDecl* become(const clang::CXXRecordDecl* type) { return std::exchange(type_, type); }
    const clang::CXXRecordDecl* type() const { return type_; }
    const clang::CXXMethodDecl& overriderOf(const clang::CXXMethodDecl& method, const Place& self) const;

    /// True, with a remark the first time, after too many steps or at too many nested calls.
    bool isTooMuch(clang::SourceLocation at);
    bool isTooDeep(clang::SourceLocation at);
    void countAnew() { steps_ = 0; }

private:
    Findings& findings_;
    std::vector<Frame> frames_;
    const clang::CXXRecordDecl* type_ = nullptr;
    unsigned steps_ = 0;
};

}  // namespace oroforge::cxx

#endif
