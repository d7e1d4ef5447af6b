// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_ROLLING_FILE_APPENDER_HPP
#define ORO_OCL_ROLLING_FILE_APPENDER_HPP

#include <ocl/FileAppender.hpp>

namespace OCL {
namespace logging {

/**
 * A file that is begun anew when it has MaxFileSize bytes: F becomes F.1, F.1 becomes F.2 and so on up to
 * F.<MaxBackupIndex>, which is removed. With a MaxBackupIndex of 0, F is emptied. No line is divided.
 */
class OCL_API RollingFileAppender : public FileAppender {
public:
    explicit RollingFileAppender(std::string name);
    ~RollingFileAppender() override;

protected:
    bool configureHook() override;
    std::unique_ptr<FileLines> makeLines(const std::string& file) override;

    RTT::Property<int> maxFileSize_prop;
    RTT::Property<int> maxBackupIndex_prop;
};

}  // namespace logging
}  // namespace OCL

#endif
