// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which of the listed headers a type comes with, and which of them another one needs to be included before it.
///
///     words, includes, macros (IncludeWatch) ─┐
///     declarations of the whole text ─────────┴─► per file: what it needs of others ─► per header: which ones before it
///
/// Bodies of functions are not parsed, so what a header needs is told from its words: whatever is declared under that name
/// outside of what it includes itself. That may be too much, and then a header is included that need not be.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_HEADER_NEEDS_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_HEADER_NEEDS_HPP

#include <vector>

#include <model/type_model.hpp>

#include "include_watch.hpp"

namespace oroforge::cxx {

class HeaderNeeds {
public:
    /// Without headers, or with one, there is nothing to find out: all answers are empty.
    HeaderNeeds(const std::vector<model::Header>& headers, const IncludeWatch& read, const clang::ASTContext& context);

    /// Those of the headers before it that it does not compile without, by their numbers.
    std::vector<std::size_t> before(std::size_t header) const;

    /// What the type is made of, itself and the arguments of a template: for each, the headers that bring it along.
    model::Homes homesOf(const clang::TagDecl& type) const;

private:
    using Files = std::vector<std::size_t>;  // any of which will do
    std::size_t bestBefore(std::size_t header, const Files& files) const;
    bool reachesAny(std::size_t header, const Files& files) const;
    std::vector<std::size_t> headersThatBring(std::size_t file) const;
    void findReach();
    void addHomes(const clang::TagDecl& type, model::Homes& to) const;
    void addHomes(const clang::TemplateArgument& argument, model::Homes& to) const;

    const IncludeWatch& read_;
    std::vector<std::size_t> listed_;         // the files of the headers
    std::vector<std::vector<bool>> reach_;    // per header, per file
    std::vector<std::vector<Files>> needed_;  // per file
    std::vector<std::size_t> needy_;          // the files of which that is not empty
};

}  // namespace oroforge::cxx

#endif
