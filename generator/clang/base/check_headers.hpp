// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Checks the include guard of a listed header.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_CHECK_HEADERS_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_CHECK_HEADERS_HPP

#include <set>

#include <diag/sink.hpp>

#include "source_places.hpp"

namespace oroforge::cxx {

class HeaderCheck {
public:
    HeaderCheck(clang::Preprocessor& preprocessor, const SourcePlaces& places, diag::Sink& sink)
        : preprocessor_(preprocessor), places_(places), sink_(sink) {}

    /// A guard copied from another header makes the compiler skip everything in this one: reports error TK063.
    void checkRead(const model::Header& header);

    /// Reports warning TK062, once for each header, if the header of the type has no guard. Generated code includes it
    /// once, but code that uses the typekit may include it again.
    void checkGuard(const clang::TagDecl& type);

private:
    clang::Preprocessor& preprocessor_;
    const SourcePlaces& places_;
    diag::Sink& sink_;
    std::set<clang::FileID> known_;
};

}  // namespace oroforge::cxx

#endif
