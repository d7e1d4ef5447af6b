// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Replaces many files together.
#ifndef OROFORGE_GENERATOR_EMIT_TRANSACTION_HPP
#define OROFORGE_GENERATOR_EMIT_TRANSACTION_HPP

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::emit {

/// Unless committed, the destructor undoes everything: drafts, new directories, renamed files. A target that is a
/// symbolic link is replaced, not followed; devices and pipes are written to.
class Transaction {
public:
    explicit Transaction(diag::Sink& sink) : sink_(sink) {}
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    /// Writes `text` beside `target`. Returns false after an error EMIT001 if that fails.
    bool stage(const std::filesystem::path& target, const std::string& text);

    /// Puts all files into their places, or none.
    bool commit();

private:
    struct Staged {
        std::filesystem::path target;
        std::string draft;   // empty once renamed
        std::string backup;  // empty if there was nothing before
    };
    struct Direct {
        std::filesystem::path target;
        std::string text;
    };

    bool makeDirectories(const std::filesystem::path& directory);
    bool replace(Staged& file);
    bool fail(const std::filesystem::path& path, const std::string& what, const std::error_code& error);
    void rollBack();

    diag::Sink& sink_;
    std::vector<Staged> staged_;
    std::vector<Direct> direct_;
    std::vector<std::filesystem::path> directories_;
    bool done_ = false;
};

}  // namespace oroforge::emit

#endif
