// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_TEXT_TARGET_HPP
#define ORO_OCL_REPORTING_TEXT_TARGET_HPP

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>

namespace OCL::reporting {

/** Writes the lines of a report. Used by one thread at a time. */
class TextTarget {
public:
    virtual ~TextTarget() = default;
    /** Writes whole lines. Returns the reason of a failure, or nothing. */
    virtual std::string write(const char* text, std::size_t size) = 0;
    /** The name of the target in errors. */
    virtual std::string name() const = 0;
};

/** Begins the file anew. If it cannot be opened, or any process writes a report to it, returns null with the reason. */
std::unique_ptr<TextTarget> openFile(const std::string& name, std::string& error);
/** Writes to a stream, which must outlive the target. */
std::unique_ptr<TextTarget> useStream(std::ostream& stream);

}  // namespace OCL::reporting

#endif
