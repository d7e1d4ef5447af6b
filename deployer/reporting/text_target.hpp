// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_TEXT_TARGET_HPP
#define ORO_OCL_REPORTING_TEXT_TARGET_HPP

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>

namespace OCL::reporting {

/** Where the lines of a report go. Used by one thread at a time. */
class TextTarget {
public:
    virtual ~TextTarget() = default;
    /** Whole lines. Returns why they could not be written, or nothing. */
    virtual std::string write(const char* text, std::size_t size) = 0;
    /** What errors call it. */
    virtual std::string name() const = 0;
};

/** Begins the file anew; null, and `error` says why, if it cannot be opened, or has a target already in whatever process. */
std::unique_ptr<TextTarget> openFile(const std::string& name, std::string& error);
/** A stream that must outlive the target. */
std::unique_ptr<TextTarget> useStream(std::ostream& stream);

}  // namespace OCL::reporting

#endif
