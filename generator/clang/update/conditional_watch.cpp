// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "conditional_watch.hpp"

#include <algorithm>

namespace oroforge::cxx {

namespace {

class Watch : public clang::PPCallbacks {
public:
    Watch(const clang::SourceManager& sources, const SourceRun& run, std::map<std::string, model::Conditionals>& into)
        : sources_(sources), places_(sources, run), into_(into) {}

    void Endif(clang::SourceLocation at, clang::SourceLocation ifAt) override {
        const std::string file = places_.fileOf(at);
        if (!file.empty() && !places_.isBehind(ifAt)) addOnce(into_[file].blocks, {lineBegin(ifAt), lineEnd(at)});
    }
    void SourceRangeSkipped(clang::SourceRange range, clang::SourceLocation) override {
        const std::string file = places_.fileOf(range.getBegin());
        if (!file.empty()) addOnce(into_[file].skipped, {lineBegin(range.getBegin()), lineEnd(range.getEnd())});
    }

private:
    static void addOnce(std::vector<model::Span>& list, model::Span span) {
        if (std::find(list.begin(), list.end(), span) == list.end()) list.push_back(span);
    }
    llvm::StringRef textAround(clang::SourceLocation at) const {
        return sources_.getBufferData(sources_.getFileID(at));
    }
    std::size_t lineBegin(clang::SourceLocation at) const {
        const std::size_t newline = textAround(at).rfind('\n', places_.offset(at));
        return newline == llvm::StringRef::npos ? 0 : newline + 1;
    }
    std::size_t lineEnd(clang::SourceLocation at) const {
        const llvm::StringRef text = textAround(at);
        const std::size_t newline = text.find('\n', places_.offset(at));
        return newline == llvm::StringRef::npos ? text.size() : newline + 1;
    }

    const clang::SourceManager& sources_;
    const PackagePlaces places_;
    std::map<std::string, model::Conditionals>& into_;
};

}  // namespace

void watchConditionals(clang::Preprocessor& preprocessor, const SourceRun& run,
                       std::map<std::string, model::Conditionals>& into) {
    preprocessor.addPPCallbacks(std::make_unique<Watch>(preprocessor.getSourceManager(), run, into));
}

}  // namespace oroforge::cxx
