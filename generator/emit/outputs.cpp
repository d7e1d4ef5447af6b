// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <emit/outputs.hpp>

#include <fstream>
#include <iterator>
#include <ostream>
#include <sstream>

#include <unistd.h>

#include <emit/banner.hpp>

namespace fs = std::filesystem;

namespace oroforge::emit {

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

namespace {

bool hasText(const fs::path& file, const std::string& text) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return false;
    return textOf(file) == text;
}

/// Something stands there that nobody generated. An empty file is nothing that could be lost.
bool isForeign(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return false;
    const std::string text = textOf(file);
    return !text.empty() && !hasBanner(text);
}

/// Undoes what was done so far unless it is kept: temporary files, new directories, renamed files.
class Transaction {
public:
    explicit Transaction(diag::Sink& sink) : sink_(sink) {}
    ~Transaction() {
        if (!done_) rollBack();
    }

    bool makeDirectories(const fs::path& directory) {
        std::error_code error;
        if (directory.empty() || fs::is_directory(directory, error)) return true;
        if (!makeDirectories(directory.parent_path())) return false;
        if (fs::create_directory(directory, error)) {
            directories_.push_back(directory);
            return true;
        }
        return fs::is_directory(directory) || fail(directory, "cannot make the directory", error);
    }

    bool stage(const fs::path& target, const std::string& text) {
        std::error_code error;
        if (fs::is_directory(target, error)) return fail(target, "found a directory, expected a file or nothing", {});
        if (!makeDirectories(target.parent_path())) return false;
        // The process id keeps two runs into one directory apart.
        const fs::path temporary = target.string() + ".new" + std::to_string(::getpid());
        staged_.push_back({target, temporary, {}});
        std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
        out << text;
        out.close();
        return out || fail(target, "cannot write the file", {});
    }

    bool commit() {
        for (Staged& file : staged_) {
            std::error_code error;
            if (fs::exists(file.target, error)) {
                // A second name for the old file: the target itself never disappears, even for a moment.
                file.backup = file.temporary.string() + ".old";
                fs::create_hard_link(file.target, file.backup, error);
                if (error) fs::copy_file(file.target, file.backup, error);
                if (error) return fail(file.target, "cannot replace the file", error);
            }
            fs::rename(file.temporary, file.target, error);
            if (error) return fail(file.target, "cannot write the file", error);
            file.temporary.clear();
        }
        for (const Staged& file : staged_) {
            std::error_code ignored;
            if (!file.backup.empty()) fs::remove(file.backup, ignored);
        }
        done_ = true;
        return true;
    }

private:
    struct Staged {
        fs::path target;
        fs::path temporary;  // empty once renamed
        fs::path backup;     // empty if there was nothing before
    };

    bool fail(const fs::path& path, const std::string& what, const std::error_code& error) {
        sink_.error({path.string(), 0, 0}, "EMIT001", error ? what + ": " + error.message() : what);
        return false;
    }

    void rollBack() {
        std::error_code ignored;
        for (const Staged& file : staged_) {
            if (file.temporary.empty()) {
                fs::remove(file.target, ignored);
            } else {
                fs::remove(file.temporary, ignored);
            }
            if (!file.backup.empty()) fs::rename(file.backup, file.target, ignored);
        }
        for (auto it = directories_.rbegin(); it != directories_.rend(); ++it) fs::remove(*it, ignored);
    }

    diag::Sink& sink_;
    std::vector<Staged> staged_;
    std::vector<fs::path> directories_;
    bool done_ = false;
};

/// The first line that differs, and what it is to be.
Difference differenceOf(const std::string& found, const std::string& expected, const std::string& tool) {
    std::istringstream one(found), other(expected);
    std::string line, wanted;
    for (unsigned number = 1;; ++number) {
        const bool more = static_cast<bool>(std::getline(one, line));
        const bool due = static_cast<bool>(std::getline(other, wanted));
        if (more && due && line == wanted) continue;
        if (more && due && line == wanted + "\r") return {"", number, "stale: lines end with CR LF, expected LF"};
        if (more && due) return {"", number, "stale: " + tool + " now writes '" + wanted + "' here"};
        if (due) return {"", number, "stale: the file ends before the line '" + wanted + "'"};
        return {"", more ? number : 0, "stale: " + tool + " now writes fewer lines"};
    }
}

}  // namespace

bool write(const Outputs& outputs, const fs::path& directory, diag::Sink& sink, Written* written) {
    Transaction transaction(sink);
    Written result;
    for (const auto& [name, text] : outputs) {
        const fs::path target = directory / name;
        if (hasText(target, text)) {
            result.unchanged.push_back(name);
            continue;
        }
        if (!transaction.stage(target, text)) return false;
        result.changed.push_back(name);
    }
    if (!transaction.commit()) return false;
    if (written != nullptr) *written = result;
    return true;
}

std::vector<Difference> compare(const Outputs& outputs, const fs::path& directory, const std::string& tool) {
    std::vector<Difference> result;
    for (const auto& [name, text] : outputs) {
        std::error_code ignored;
        if (!fs::is_regular_file(directory / name, ignored)) {
            result.push_back({name, 0, "missing: " + tool + " would write this file"});
        } else if (const std::string found = textOf(directory / name); found != text) {
            result.push_back(differenceOf(found, text, tool));
            result.back().name = name;
        }
    }
    return result;
}

bool writeGenerated(const Outputs& outputs, const fs::path& directory, diag::Sink& sink, Written* written) {
    for (const auto& [name, text] : outputs) {
        if (!hasBanner(text) || !isForeign(directory / name)) continue;
        sink.error({(directory / name).string()}, "EMIT002", "this file was not generated; it would be written over")
            .hint("choose another output folder, or another build folder, or remove the file");
        return false;
    }
    return write(outputs, directory, sink, written);
}

void listOutputs(std::ostream& out, const Outputs& outputs, const fs::path& directory) {
    for (const auto& entry : outputs) out << (directory / entry.first).string() << '\n';
}

void listOutputs(std::ostream& out, const std::vector<std::string>& outputs, const fs::path& directory) {
    for (const std::string& name : outputs) out << (directory / name).string() << '\n';
}

}  // namespace oroforge::emit
