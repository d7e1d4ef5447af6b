// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_FILE_APPENDER_HPP
#define ORO_OCL_FILE_APPENDER_HPP

#include <ocl/Appender.hpp>

#include <memory>
#include <string>

namespace OCL {
namespace logging {

class FileLines;

/**
 * Appends events to the file that the property Filename names. Whole lines reach the file, whatever ends the process.
 * While it cannot be written (full disk, folder removed), events are counted and lost; the file is opened again when
 * that is possible. start() returns false if the file cannot be opened.
 */
class OCL_API FileAppender : public Appender {
public:
    explicit FileAppender(std::string name);
    ~FileAppender() override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    /** The writer for that file. */
    virtual std::unique_ptr<FileLines> makeLines(const std::string& file);

    RTT::Property<std::string> filename_prop;
    RTT::Property<int> maxEventsPerCycle_prop;
};

}  // namespace logging
}  // namespace OCL

#endif
