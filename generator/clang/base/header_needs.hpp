// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds which listed headers provide a type, and which of them another header needs to be included before it.
///
///     words, includes, macros (IncludeWatch) ─┐
///     declarations of the whole text ─────────┴─► per file: what it needs of others ─► per header: those before it
///
/// Bodies of functions are not parsed, so a header's needs come from its words: every declaration with such a name
/// outside of its own includes. That may be too much, and then an unneeded header is included.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_HEADER_NEEDS_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_HEADER_NEEDS_HPP

#include <vector>

#include <model/type_model.hpp>

#include "include_watch.hpp"

namespace oroforge::cxx {

class HeaderNeeds {
public:
    /// With fewer than two headers all answers are empty.
    HeaderNeeds(const std::vector<model::Header>& headers, const IncludeWatch& read, const clang::ASTContext& context);

    /// Returns the numbers of the headers before it that it does not compile without.
    std::vector<std::size_t> before(std::size_t header) const;

    /// Returns the headers that provide the type itself, and those for each of its template arguments.
    model::Homes homesOf(const clang::TagDecl& type) const;

private:
    using Files = std::vector<std::size_t>;  // any one of them is enough
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
    std::vector<std::size_t> needy_;          // files whose entry there is not empty
};

}  // namespace oroforge::cxx

#endif
