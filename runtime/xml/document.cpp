// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/document.hpp>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>
#include <utility>

#include <xml/detail/encoding.hpp>
#include <xml/detail/scanner.hpp>

namespace oroforge::xml {

namespace {

bool isReadable(const std::string& text, const std::string& name, diag::Sink& sink) {
    if (text.size() > std::numeric_limits<Offset>::max()) {
        sink.error({name, 0, 0}, "XML011", "the file has 4 GiB or more; expected less");
        return false;
    }
    return detail::checkEncoding(text, name, sink);
}

}  // namespace

std::optional<std::string> readText(const std::string& path, diag::Sink& sink) {
    std::ifstream in(path, std::ios::binary);
    const int reason = errno;
    std::error_code ignored;
    const bool isDirectory = std::filesystem::is_directory(path, ignored);
    if (!in || isDirectory) {
        sink.error(
            {path, 0, 0}, "XML001",
            "cannot read the file: " + (isDirectory ? "it is a directory" : std::generic_category().message(reason)));
        return std::nullopt;
    }
    std::string text;
    std::array<char, 1 << 16> piece;
    do {
        in.read(piece.data(), piece.size());
        text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    } while (in);
    return text;
}

std::optional<Document> Document::parseFile(const std::string& path, diag::Sink& sink, Blanks blanks) {
    const auto text = readText(path, sink);
    return text ? parseText(*text, path, sink, blanks) : std::nullopt;
}

std::optional<Document> Document::parseText(const std::string& text, const std::string& name, diag::Sink& sink,
                                            Blanks blanks) {
    if (!isReadable(text, name, sink)) return std::nullopt;
    return document(detail::scan(text, name, sink, {blanks}));
}

std::optional<Document> Document::parseText(const std::string& text, const std::string& name, diag::Sink& sink,
                                            Blanks blanks, const ChildConsumer& take) {
    if (!isReadable(text, name, sink)) return std::nullopt;
    if (!detail::scan(text, name, sink, {blanks, /*keep=*/false})) return std::nullopt;
    return document(detail::scan(text, name, sink, {blanks, /*keep=*/true, take}));
}

std::optional<Document> Document::document(std::optional<Element> root) {
    return root ? std::optional<Document>(Document(std::move(*root))) : std::nullopt;
}

}  // namespace oroforge::xml
