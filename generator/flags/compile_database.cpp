// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "compile_database.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <tuple>

#include <diag/nearest_match.hpp>
#include <nlohmann/json.hpp>

#include "command_words.hpp"

namespace fs = std::filesystem;

namespace oroforge::flags {

namespace {

using nlohmann::json;

struct Entry {
    std::string file;  ///< absolute
    std::string directory;
    std::string output;
    std::vector<std::string> words;
};

fs::path absoluteOf(const fs::path& path) { return fs::absolute(path).lexically_normal(); }

/// True if a path ends with the parts of another: "src/a.cpp" ends "/x/src/a.cpp".
bool endsWith(const fs::path& path, const fs::path& end) {
    auto part = path.end();
    for (auto wanted = end.end(); wanted != end.begin();) {
        --wanted;
        if (part == path.begin() || *--part != *wanted) return false;
    }
    return !end.empty();
}

std::string headerNamed(const std::string& line) {
    std::size_t at = line.find_first_not_of(" \t");
    if (at == std::string::npos || line[at] != '#') return {};
    at = line.find_first_not_of(" \t", at + 1);
    if (at == std::string::npos || line.compare(at, 7, "include") != 0) return {};
    at = line.find_first_of("<\"", at);
    if (at == std::string::npos) return {};
    const std::size_t end = line.find(line[at] == '<' ? '>' : '"', at + 1);
    return end == std::string::npos ? std::string() : line.substr(at + 1, end - at - 1);
}

/// Removes "..": "../x/y.hpp" may be x/y.hpp in any folder.
fs::path withoutDots(const std::string& name) {
    fs::path result;
    for (const fs::path& part : fs::path(name).lexically_normal()) {
        if (part != "..") result /= part;
    }
    return result;
}

std::size_t includedBy(const std::string& source, const std::vector<fs::path>& headers) {
    std::set<std::size_t> found;
    std::ifstream in(source);
    for (std::string line; std::getline(in, line);) {
        const std::string name = headerNamed(line);
        for (std::size_t i = 0; !name.empty() && i < headers.size(); ++i) {
            if (endsWith(headers[i], withoutDots(name))) found.insert(i);
        }
    }
    return found.size();
}

std::size_t commonParts(const fs::path& one, const fs::path& other) {
    const auto [end, unused] = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
    return static_cast<std::size_t>(std::distance(one.begin(), end));
}

constexpr std::size_t kNear = 2;  // common parts of near paths: more than the root

bool isCxx(const fs::path& source) {
    static const std::set<std::string> known = {".cc", ".cpp", ".cxx", ".c++", ".C"};
    return known.count(source.extension().string()) != 0;
}

/// Returns the name of the CMake target of an object file, or nothing.
std::string targetOf(const std::string& output) {
    for (const fs::path& part : fs::path(output)) {
        if (part.extension() == ".dir") return part.stem().string();
    }
    return {};
}

class Database {
public:
    Database(std::string file, diag::Sink& sink) : file_(std::move(file)), sink_(sink) {}

    const std::string& file() const { return file_; }

    bool read() {
        std::ifstream in(file_, std::ios::binary);
        if (!in || fs::is_directory(file_)) {
            error("no such compile database, expected a file or the folder of a compile_commands.json")
                .hint("CMake writes it with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON");
            return false;
        }
        const std::string text(std::istreambuf_iterator<char>(in), {});
        try {
            const json document = json::parse(text);
            if (document.is_array()) return take(document);
            error("found a JSON " + std::string(document.type_name()) + ", expected a list of commands");
        } catch (const json::parse_error& failure) {
            broken(text, failure);
        }
        return false;
    }

    const Entry* named(const std::string& wanted) {
        std::vector<const Entry*> found;
        const fs::path end = fs::path(wanted).lexically_normal();
        for (const Entry& entry : entries_) {
            if (endsWith(entry.file, end) || entry.file == absoluteOf(wanted)) found.push_back(&entry);
        }
        for (const Entry* other : found) {
            if (flagsOf(*other) == flagsOf(*found[0])) continue;
            error("'" + wanted + "' is compiled twice, with different options: " + shown(*found[0]) + " and " +
                  shown(*other))
                .hint("name more of the path, or the target, with --compile-database-for");
            return nullptr;
        }
        if (!found.empty()) return found[0];
        for (const Entry& entry : entries_) {
            if (targetOf(entry.output) == wanted) return &entry;
        }
        std::vector<std::string> known;
        for (const Entry& entry : entries_) {
            known.push_back(fs::path(entry.file).filename().string());
            known.push_back(targetOf(entry.output));
        }
        error("no entry of a source or a target '" + wanted + "'" + diag::didYouMean(wanted, known));
        return nullptr;
    }

    const Entry* best(const std::vector<std::string>& inputs) {
        std::vector<fs::path> headers;
        for (const std::string& header : inputs) headers.push_back(absoluteOf(header));
        const Entry* found = nullptr;
        std::tuple<bool, std::size_t, bool, std::size_t> most;
        for (const Entry& entry : entries_) {
            bool sameName = false;
            std::size_t near = 0;
            for (const fs::path& header : headers) {
                sameName |= header.stem() == fs::path(entry.file).stem();
                near = std::max(near, commonParts(header.parent_path(), fs::path(entry.file).parent_path()));
            }
            const auto rank = std::make_tuple(isCxx(entry.file), includedBy(entry.file, headers), sameName, near);
            if (found != nullptr && rank <= most) continue;
            found = &entry;
            most = rank;
        }
        if (found == nullptr) {
            error("no entry in this compile database, expected one for each source of a program");
        } else if (std::get<1>(most) == 0 && !std::get<2>(most) && std::get<3>(most) < kNear) {
            error("no source in this compile database includes one of the headers, is called as one, or lies near")
                .hint("name a source or a target with --compile-database-for");
            return nullptr;
        }
        return found;
    }

    static std::vector<std::string> flagsOf(const Entry& entry) { return flagsOfCommand(entry.words, entry.directory); }

private:
    diag::Diagnostic& error(const std::string& message) { return sink_.error({file_}, "TK066", message); }

    static std::string shown(const Entry& entry) {
        const std::string target = targetOf(entry.output);
        return entry.file + (target.empty() ? "" : " of target " + target);
    }

    void broken(const std::string& text, const json::parse_error& failure) {
        const std::size_t end = std::min(failure.byte > 0 ? failure.byte - 1 : 0, text.size());
        const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n') + 1;
        const std::size_t before = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
        const std::size_t column = end - (before == std::string::npos ? 0 : before + 1) + 1;
        const std::string found = end >= text.size() ? "the end of the file" : "'" + text.substr(end, 1) + "'";
        sink_.error({file_, static_cast<unsigned>(line), static_cast<unsigned>(column)}, "TK066",
                    "this is not JSON: unexpected " + found);
    }

    bool take(const json& document) {
        std::size_t number = 0;
        bool good = true;
        for (const json& item : document) {
            ++number;
            Entry entry;
            if (const std::string fault = entryOf(item, entry); fault.empty()) {
                entries_.push_back(std::move(entry));
            } else {
                error("entry " + std::to_string(number) + " " + fault);
                good = false;
            }
        }
        return good;
    }

    std::string entryOf(const json& item, Entry& entry) const {
        if (!item.is_object()) return std::string("is a JSON ") + item.type_name() + ", expected an object";
        const auto text = [&item](const char* key) {
            return item.contains(key) && item[key].is_string() ? item[key].get<std::string>() : std::string();
        };
        if (text("file").empty()) return "has no text 'file'";
        if (text("directory").empty()) return "(" + text("file") + ") has no text 'directory'";
        if (const auto words = item.find("arguments"); words != item.end()) {
            if (!words->is_array()) return "(" + text("file") + ") has 'arguments' that are no list";
            for (const json& word : *words) {
                if (!word.is_string()) return "(" + text("file") + ") has 'arguments' that are not all texts";
                entry.words.push_back(word.get<std::string>());
            }
        } else if (!text("command").empty()) {
            entry.words = splitCommand(text("command"));
        } else {
            return "(" + text("file") + ") has neither 'command' nor 'arguments'";
        }
        // Relative folders are below the database's folder, so that a database can be moved.
        const fs::path directory = absoluteOf(file_).parent_path() / text("directory");
        entry.directory = directory.lexically_normal().string();
        entry.file = (directory / text("file")).lexically_normal().string();
        entry.output = text("output").empty() ? outputOfCommand(entry.words) : text("output");
        return {};
    }

    std::string file_;
    diag::Sink& sink_;
    std::vector<Entry> entries_;
};

std::string macroOf(const std::string& value) { return value.substr(0, value.find_first_of("=(")); }

}  // namespace

std::string compileDatabaseFile(const std::string& database) {
    std::error_code ignored;
    return fs::is_directory(database, ignored) ? (fs::path(database) / "compile_commands.json").string() : database;
}

std::optional<DatabaseFlags> readCompileDatabase(const std::string& database, const std::string& wanted,
                                                 const std::vector<std::string>& headers, diag::Sink& sink) {
    Database entries(compileDatabaseFile(database), sink);
    if (!entries.read()) return std::nullopt;
    const Entry* entry = wanted.empty() ? entries.best(headers) : entries.named(wanted);
    if (entry == nullptr) return std::nullopt;
    return DatabaseFlags{Database::flagsOf(*entry), entries.file(), entry->file};
}

std::vector<std::string> withoutOverridden(const std::vector<std::string>& flags,
                                           const std::vector<std::string>& stronger) {
    std::set<std::string> macros;
    bool hasStandard = false;
    for (std::size_t i = 0; i < stronger.size(); ++i) {
        hasStandard |= stronger[i].compare(0, 5, "-std=") == 0;
        if ((stronger[i] == "-D" || stronger[i] == "-U") && i + 1 < stronger.size())
            macros.insert(macroOf(stronger[++i]));
    }
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i].compare(0, 5, "-std=") == 0) {
            if (!hasStandard) kept.push_back(flags[i]);
            continue;
        }
        if (i + 1 == flags.size()) break;
        const bool isMacro = flags[i] == "-D" || flags[i] == "-U";
        if (!isMacro || macros.count(macroOf(flags[i + 1])) == 0) kept.insert(kept.end(), {flags[i], flags[i + 1]});
        ++i;
    }
    return kept;
}

}  // namespace oroforge::flags
