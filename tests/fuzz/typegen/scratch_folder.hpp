// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A folder for the files of one fuzzer; in memory, if the system has such a place.
#ifndef TESTS_FUZZ_TYPEGEN_SCRATCH_FOLDER_HPP
#define TESTS_FUZZ_TYPEGEN_SCRATCH_FOLDER_HPP

#include "../fuzzing.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace oroforge::fuzz {

class ScratchFolder {
public:
    ScratchFolder() {
        namespace fs = std::filesystem;
        const fs::path memory = "/dev/shm";
        std::string name =
            ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "oroforge-XXXXXX").string();
        require(mkdtemp(name.data()) != nullptr, "there is a place for temporary files", name);
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    /// The path of the file.
    std::string write(const std::string& name, const std::string& text) const {
        const std::string path = (path_ / name).string();
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }

private:
    std::filesystem::path path_;
};

}  // namespace oroforge::fuzz

#endif
