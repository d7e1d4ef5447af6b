// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "standard_include.hpp"

namespace oroforge::cxx {

namespace {

struct StandardName {
    const char* header;
    const char* names;  ///< each between blanks
};

constexpr StandardName kStandardNames[] = {
    {"any", " any any_cast "},
    {"array", " array "},
    {"atomic", " atomic atomic_bool atomic_int "},
    {"bitset", " bitset "},
    {"chrono", " chrono "},
    {"complex", " complex "},
    {"cstddef", " byte nullptr_t ptrdiff_t size_t "},
    {"cstdint",
     " int8_t int16_t int32_t int64_t intptr_t uint8_t uint16_t uint32_t uint64_t uintptr_t intmax_t uintmax_t "},
    {"deque", " deque "},
    {"exception", " exception exception_ptr "},
    {"filesystem", " filesystem "},
    {"forward_list", " forward_list "},
    {"functional", " function hash less greater "},
    {"initializer_list", " initializer_list "},
    {"iostream", " cout cerr "},
    {"limits", " numeric_limits "},
    {"list", " list "},
    {"map", " map multimap "},
    {"memory", " unique_ptr shared_ptr weak_ptr make_unique make_shared allocator "},
    {"mutex", " mutex recursive_mutex lock_guard unique_lock "},
    {"optional", " optional nullopt "},
    {"ostream", " ostream "},
    {"istream", " istream "},
    {"queue", " queue priority_queue "},
    {"ratio", " ratio milli micro nano "},
    {"set", " set multiset "},
    {"sstream", " stringstream ostringstream istringstream "},
    {"stack", " stack "},
    {"stdexcept", " runtime_error logic_error invalid_argument out_of_range "},
    {"string", " string wstring u16string u32string basic_string to_string "},
    {"string_view", " string_view "},
    {"thread", " thread "},
    {"tuple", " tuple tie "},
    {"type_traits", " enable_if enable_if_t is_same decay_t "},
    {"unordered_map", " unordered_map unordered_multimap "},
    {"unordered_set", " unordered_set unordered_multiset "},
    {"utility", " pair move swap make_pair "},
    {"valarray", " valarray "},
    {"variant", " variant monostate "},
    {"vector", " vector "},
};

std::string headerOf(llvm::StringRef name) {
    const std::string word = " " + name.str() + " ";
    for (const StandardName& one : kStandardNames)
        if (std::string(one.names).find(word) != std::string::npos) return one.header;
    return "";
}

llvm::StringRef wordAt(llvm::StringRef text) {
    return text.take_while([](char c) { return clang::isAsciiIdentifierContinue(c); });
}

/// Returns "vector" if the text at the place is `std::vector`.
llvm::StringRef nameBehindStd(const clang::Diagnostic& info) {
    if (!info.hasSourceManager() || info.getLocation().isInvalid()) return "";
    const clang::SourceManager& sources = info.getSourceManager();
    bool invalid = false;
    const char* text = sources.getCharacterData(sources.getSpellingLoc(info.getLocation()), &invalid);
    if (invalid) return "";
    llvm::StringRef rest(text);  // buffers end with a null character
    if (!rest.consume_front("std")) return "";
    rest = rest.ltrim();
    if (!rest.consume_front("::")) return "";
    return wordAt(rest.ltrim());
}

}  // namespace

std::string missingInclude(const clang::Diagnostic& info, llvm::StringRef message) {
    const auto [before, behind] = message.split('\'');
    llvm::StringRef name = behind;
    const bool isStd = name.consume_front("std::") || message.contains("in namespace 'std'");
    name = wordAt(name);
    // No header of the library has been included before.
    if (name == "std" && before.contains("undeclared"))
        return missingInclude(info, ("'std::" + nameBehindStd(info)).str());
    const std::string header = headerOf(name);
    // Without std::, only names of C are meant to be the library's.
    const bool isMeant = isStd || (before.contains("unknown type name") && (header == "cstdint" || name == "size_t"));
    const bool isUnknown = isStd ? before.contains("no ") || before.contains("undefined") || before.empty() : true;
    return header.empty() || !isMeant || !isUnknown ? "" : "#include <" + header + ">";
}

}  // namespace oroforge::cxx
