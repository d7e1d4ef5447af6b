// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "listed_types.hpp"

#include <rtt/os/descriptor.hpp>

#include <fcntl.h>
#include <link.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>

namespace RTT::plugin {
namespace {

constexpr char kSection[] = "orocos_types";
constexpr std::uint64_t kMost = 1 << 20;  // bytes of a table or of the names; more is damage

bool readAt(int file, std::uint64_t offset, void* to, std::uint64_t size) {
    return size <= kMost && offset <= INT64_MAX &&
           pread(file, to, size, static_cast<off_t>(offset)) == static_cast<ssize_t>(size);
}

/** The bytes of a section of the file; empty if they cannot be read. */
std::string contentOf(int file, const ElfW(Shdr) & section) {
    if (section.sh_type == SHT_NOBITS || section.sh_size > kMost) return {};
    std::string content(section.sh_size, '\0');
    return readAt(file, section.sh_offset, content.data(), content.size()) ? content : std::string();
}

std::vector<ElfW(Shdr)> sectionsOf(int file, const ElfW(Ehdr) & head) {
    std::vector<ElfW(Shdr)> sections(head.e_shnum);
    if (!readAt(file, head.e_shoff, sections.data(), sections.size() * sizeof(ElfW(Shdr)))) sections.clear();
    return sections;
}

/** The texts between zero bytes, of which there may be several for alignment. */
std::vector<std::string> textsIn(const std::string& content) {
    std::vector<std::string> texts;
    for (std::size_t begin = 0; begin < content.size();) {
        const std::size_t end = content.find('\0', begin);
        if (end == std::string::npos) break;
        if (end != begin) texts.push_back(content.substr(begin, end - begin));
        begin = end + 1;
    }
    return texts;
}

}  // namespace

std::vector<std::string> listedTypes(const std::string& file) {
    const os::detail::Descriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (!opened) return {};
    ElfW(Ehdr) head;
    if (!readAt(opened.get(), 0, &head, sizeof head) || std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 ||
        head.e_ident[EI_CLASS] != (sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32) ||
        head.e_shentsize != sizeof(ElfW(Shdr)))
        return {};
    const std::vector<ElfW(Shdr)> sections = sectionsOf(opened.get(), head);
    if (head.e_shstrndx >= sections.size()) return {};
    const std::string names = contentOf(opened.get(), sections[head.e_shstrndx]);
    for (const ElfW(Shdr) & section : sections)
        if (section.sh_name < names.size() && std::strcmp(names.c_str() + section.sh_name, kSection) == 0)
            return textsIn(contentOf(opened.get(), section));
    return {};
}

}  // namespace RTT::plugin
