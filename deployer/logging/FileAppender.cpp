// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/FileAppender.hpp>
#include <ocl/GenerationalFileAppender.hpp>
#include <ocl/RollingFileAppender.hpp>

#include "file_lines.hpp"

#include <rtt/Logger.hpp>

namespace OCL::logging {

FileAppender::FileAppender(std::string name)
    : Appender(name),
      filename_prop("Filename", "The file to which events are appended.", ""),
      maxEventsPerCycle_prop("MaxEventsPerCycle", "How many events a cycle takes at most; 0 for all.", 1) {
    addProperty(filename_prop);
    addProperty(maxEventsPerCycle_prop);
}

FileAppender::~FileAppender() { stopForGood(); }

std::unique_ptr<FileLines> FileAppender::makeLines(const std::string& file) {
    return std::make_unique<FileLines>(getName(), file);
}

bool FileAppender::configureHook() {
    if (!isMaxEvents(maxEventsPerCycle_prop.get())) return false;
    if (filename_prop.get().empty()) {
        RTT::log(RTT::Error) << "appender '" << getName() << "' needs a file; its property Filename is empty"
                             << RTT::endlog();
        return false;
    }
    hold(makeLines(filename_prop.get()));
    return configureLayout();
}

bool FileAppender::startHook() { return Appender::startHook() && static_cast<FileLines*>(held())->open(); }

void FileAppender::updateHook() { processEvents(maxEventsPerCycle_prop.get()); }

void FileAppender::stopHook() {
    Appender::stopHook();
    static_cast<FileLines*>(held())->closeFile();
}

RollingFileAppender::RollingFileAppender(std::string name)
    : FileAppender(name),
      maxFileSize_prop("MaxFileSize", "The file is begun anew when it has that many bytes.", 10 * 1024 * 1024),
      maxBackupIndex_prop("MaxBackupIndex", "How many former files are kept.", 1) {
    addProperty(maxFileSize_prop);
    addProperty(maxBackupIndex_prop);
}

RollingFileAppender::~RollingFileAppender() { stopForGood(); }

bool RollingFileAppender::configureHook() {
    const int size = maxFileSize_prop.get(), index = maxBackupIndex_prop.get();
    constexpr int kMostFiles = 100000;  // each is renamed whenever the file is full
    if (size <= 0 || index < 0 || index > kMostFiles) {
        RTT::log(RTT::Error) << "appender '" << getName() << "': MaxFileSize is " << size << " and MaxBackupIndex is "
                             << index << "; expected at least 1, and 0 to " << kMostFiles << RTT::endlog();
        return false;
    }
    return FileAppender::configureHook();
}

std::unique_ptr<FileLines> RollingFileAppender::makeLines(const std::string& file) {
    return std::make_unique<RollingFileLines>(getName(), file, static_cast<std::uint64_t>(maxFileSize_prop.get()),
                                              static_cast<unsigned>(maxBackupIndex_prop.get()));
}

GenerationalFileAppender::GenerationalFileAppender(std::string name) : FileAppender(name) {
    addOperation("advanceGeneration", &GenerationalFileAppender::advanceGeneration, this, RTT::OwnThread)
        .doc("Gives the present file the next number, and begins it anew.");
}

GenerationalFileAppender::~GenerationalFileAppender() { stopForGood(); }

void GenerationalFileAppender::advanceGeneration() {
    if (held())
        static_cast<GenerationalFileLines*>(held())->advance();
    else
        RTT::log(RTT::Error) << "No appender to roll over! ('" << getName() << "' is not configured)" << RTT::endlog();
}

std::unique_ptr<FileLines> GenerationalFileAppender::makeLines(const std::string& file) {
    return std::make_unique<GenerationalFileLines>(getName(), file);
}

}  // namespace OCL::logging
