// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "run_record.hpp"

#include <sys/stat.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <files/draft_file.hpp>
#include <plan/stable_hash.hpp>
#include <plan/typekit_files.hpp>

namespace fs = std::filesystem;

namespace oroforge::typekit {

namespace {

struct State {
    std::int64_t time = 0;  ///< of the last change, in ns since the epoch
    std::string text;       ///< time and size; empty if there is no such file
};

State stateOf(const std::string& path) {
    struct stat is = {};
    if (::stat(path.c_str(), &is) != 0) return {};
    State state;
    state.time = is.st_mtim.tv_sec * 1000000000LL + is.st_mtim.tv_nsec;
    state.text = std::to_string(state.time) + " " + std::to_string(is.st_size);
    return state;
}

std::int64_t now() { return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count(); }

constexpr std::int64_t kTick = 20000000;  // resolution of file times, with room to spare
constexpr auto kOldest = std::chrono::hours(24 * 30);

void removeOld(const fs::path& place) {
    std::error_code error;
    const auto oldest = fs::file_time_type::clock::now() - kOldest;
    for (const fs::directory_entry& entry : fs::directory_iterator(place, error))
        if (entry.last_write_time(error) < oldest && !error) fs::remove(entry.path(), error);
}

std::string folder() {
    if (const char* set = std::getenv("TYPEGEN_CACHE")) return set;
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache != '\0') return std::string(cache) + "/oroforge/typegen";
    const char* home = std::getenv("HOME");
    return home != nullptr && *home != '\0' ? std::string(home) + "/.cache/oroforge/typegen" : std::string();
}

/// A record has one path in a line.
bool isOneLine(const std::string& path) { return path.find('\n') == std::string::npos; }

void add(std::string& text, const std::string& word) { text += std::to_string(word.size()) + ":" + word + " "; }

}  // namespace

RunRecord::RunRecord(const Options& options, const cxx::ParseRequest& request) : began_(now()) {
    const std::string place = folder();
    if (place.empty() || !options.templateDir.empty() || !options.depfile.empty()) return;
    std::error_code error;
    const fs::path here = fs::current_path(error);
    const std::string output = (here / options.output).lexically_normal().string();
    for (const std::string& name : outputNames(options.name, request.headers))
        outputs_.push_back((fs::path(output) / name).string());

    for (const std::string& word : {std::string(OROFORGE_VERSION), stateOf("/proc/self/exe").text, here.string(),
                                    output, options.name, request.target})
        add(request_, word);
    // The last two say where messages of ROS are looked for.
    for (const char* variable : {"TYPEGEN_RESOURCE_DIR", "ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH"}) {
        const char* const value = std::getenv(variable);
        add(request_, value != nullptr ? value : "");
    }
    for (const std::string& flag : request.flags) add(request_, flag);
    for (const std::string& file : options.adapters) add(request_, file);
    for (const model::Header& header : request.headers) {
        add(request_, header.path);
        add(request_, header.include);
        add(request_, std::to_string(header.pieces));
    }
    if (isOneLine(request_)) file_ = place + "/" + std::to_string(hashOf(output + "\n" + options.name));
}

bool RunRecord::isCurrent() const {
    std::ifstream file(file_);
    std::string line;
    if (file_.empty() || !std::getline(file, line) || line != request_) return false;
    bool any = false;
    while (std::getline(file, line)) {
        const std::size_t size = line.find(' '), path = line.find(' ', size + 1);
        if (path == std::string::npos || stateOf(line.substr(path + 1)).text != line.substr(0, path)) return false;
        any = true;
    }
    return any;
}

void RunRecord::keep(const std::vector<std::string>& inputs) const {
    if (file_.empty()) return;
    std::error_code error;
    fs::create_directories(fs::path(file_).parent_path(), error);
    std::string text = request_ + "\n";
    for (const auto* files : {&inputs, &outputs_}) {
        for (const std::string& path : *files) {
            const std::string absolute = fs::absolute(path, error).string();
            const State state = stateOf(absolute);
            // A file that changed after this run began may differ from what was read.
            const bool tooNew = files == &inputs && state.time > began_ - kTick;
            if (state.text.empty() || tooNew || !isOneLine(absolute)) return forget();
            text += state.text + " " + absolute + "\n";
        }
    }
    // The complete file is renamed, because another run may read it. A draft left behind is removed as an old record.
    std::string draft;
    const int descriptor = files::openDraft(file_, draft);
    if (descriptor < 0) return forget();
    if (files::writeAndClose(descriptor, text, files::Durability::process)) {
        fs::remove(draft, error);
        return forget();
    }
    fs::rename(draft, file_, error);
    removeOld(fs::path(file_).parent_path());
}

void RunRecord::forget() const {
    std::error_code error;
    if (!file_.empty()) fs::remove(file_, error);
}

}  // namespace oroforge::typekit
