// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Doubts while a constructor is followed, and remarks about them.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_FINDINGS_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_FINDINGS_HPP

#include <set>
#include <string>
#include <vector>

#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>

namespace oroforge::cxx {

class Findings {
public:
    Findings(const clang::SourceManager& sources, const SourcePlaces& places, diag::Sink& remarks)
        : sources_(sources), places_(places), remarks_(remarks) {}

    diag::Location locate(clang::SourceLocation at) const { return places_.locate(sources_, at); }
    void warn(const diag::Location& where, const char* code, const std::string& message);
    /// Does the same, unless it is about later calls: of these only their additions matter.
    diag::Diagnostic& remark(clang::SourceLocation at, const char* code, const std::string& message);

    /// While there is a doubt, nothing is added, and values of changed variables become unknown.
    void doubt(std::string why) { doubts_.push_back(std::move(why)); }
    void settle() { doubts_.pop_back(); }
    std::size_t doubts() const { return doubts_.size(); }
    void settleTo(std::size_t doubts) { doubts_.resize(doubts); }
    bool isCertain() const { return doubts_.empty(); }
    const std::string& why() const { return doubts_.back(); }
    /// Returns false, after a remark, if it may not happen.
    bool isAdded(clang::SourceLocation at, const std::string& what);

    /// From now on, code runs only after the component is made.
    void beLate(std::string why) { late_ = std::move(why); }
    bool isLate() const { return !late_.empty(); }

    /// Notes ports or properties that are missing from the result.
    void noteMore(bool more = true) { hasMore_ |= more; }
    bool hasMore() const { return hasMore_; }
    /// Notes a function whose definition would be needed, but only its declaration is known.
    void noteUnseen(const clang::FunctionDecl& function) { unseen_.insert(&function); }
    const std::set<const clang::FunctionDecl*>& unseen() const { return unseen_; }

private:
    const clang::SourceManager& sources_;
    const SourcePlaces& places_;
    diag::Sink& remarks_;
    diag::Sink unused_;
    std::vector<std::string> doubts_;  ///< the innermost last
    std::string late_;
    bool hasMore_ = false;
    std::set<const clang::FunctionDecl*> unseen_;
};

}  // namespace oroforge::cxx

#endif
