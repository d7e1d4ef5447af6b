// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_GENERATIONAL_FILE_APPENDER_HPP
#define ORO_OCL_GENERATIONAL_FILE_APPENDER_HPP

#include <ocl/FileAppender.hpp>

namespace OCL {
namespace logging {

/**
 * A file of which advanceGeneration() begins a new one: F becomes F.1 the first time, F.2 the second time, and so on.
 * No generation is ever overwritten, also not by the next process.
 */
class OCL_API GenerationalFileAppender : public FileAppender {
public:
    explicit GenerationalFileAppender(std::string name);
    ~GenerationalFileAppender() override;

    /** The operation, executed in this component's own thread. An error in the log if the component is not
        configured. */
    void advanceGeneration();

protected:
    std::unique_ptr<FileLines> makeLines(const std::string& file) override;
};

}  // namespace logging
}  // namespace OCL

#endif
